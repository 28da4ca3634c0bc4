// SPDX-License-Identifier: BSD-3-Clause
// Points, planes and lines of a patch in 3D. Draws only when something has changed.
import { AmbientLight, Box3, Color, Group, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { isDark } from '../data/colours';
import type { Method, Patch, Triple } from '../data/schema';
import { h } from '../ui/dom';
import { LineLayer, type LineColouring } from './line_layer';
import { Measure } from './measure';
import { PlaneLayer } from './plane_layer';
import { heightColours, planeColours } from './point_colours';
import { PointLayer } from './point_layer';

export class SceneView {
  readonly element = h('div', { class: 'scene', id: 'scene' });
  onPick: (line: number | null) => void = () => undefined;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly content = new Group();
  private readonly camera = new PerspectiveCamera(35, 1, 0.5, 5000);
  private readonly controls: OrbitControls;
  private readonly points = new PointLayer();
  private readonly surface = new PointLayer();
  private readonly planes = new PlaneLayer();
  private readonly lines = new LineLayer();
  readonly measure = new Measure();
  private readonly box = new Box3();
  private frame = 0;
  private isMoving = false;
  private lastFrame = 0;
  private share = 1; // share of the points that is drawn
  private width = 1;
  private height = 1;
  /** Frames drawn so far, for tests and measurements. */
  nFrames = 0;

  /** Needs WebGL 2. */
  constructor() {
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute('aria-label', '3D view of points, planes and lines');
    this.element.append(canvas);
    this.camera.up.set(0, 0, 1);
    this.content.add(this.points.object, this.surface.object, this.planes.object, this.lines.object, this.measure.object);
    this.scene.add(this.content, new AmbientLight());
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.redraw());
    this.controls.addEventListener('start', () => { this.isMoving = true; this.lastFrame = 0; });
    this.controls.addEventListener('end', () => { this.isMoving = false; this.thin(1); this.redraw(); });
    this.listenForClicks(canvas);
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.applyTheme();
  }

  show(patch: Patch, method: Method): void {
    this.surface.show(patch.surface, patch.surface && heightColours(patch.surface));
    this.fill(patch, method);
    this.measure.clear();
    this.findBox(patch, method);
    this.look('oblique');
  }

  /** Shows another method of the same patch without moving the view. */
  showMethod(patch: Patch, method: Method): void {
    this.fill(patch, method);
    this.redraw();
  }

  colourLinesBy(colouring: LineColouring): void {
    this.lines.colourBy(colouring);
    this.redraw();
  }
  setPlanesVisible(visible: boolean): void {
    this.planes.setVisible(visible);
    this.redraw();
  }
  setPointsVisible(visible: boolean): void {
    this.points.object.visible = visible;
    this.redraw();
  }
  setSurfaceVisible(visible: boolean): void {
    this.surface.object.visible = visible;
    this.redraw();
  }
  exaggerateHeights(factor: number): void {
    const base = this.box.min.z;
    this.content.scale.z = factor;
    this.content.position.z = base * (1 - factor);
    this.content.updateMatrixWorld(true);
    this.redraw();
  }

  select(line: number | null): void {
    this.lines.select(line);
    this.planes.highlight(line === null ? [] : this.lines.planesOf(line));
    this.redraw();
  }

  /** Centres the view on the line without turning it, from a distance of at most 60 m. */
  centreOn(line: number): void {
    const middle = this.lines.middleOf(line);
    if (!middle) return;
    const target = this.content.localToWorld(middle);
    const farthest_m = 60;
    const offset = this.camera.position.clone().sub(this.controls.target).clampLength(0, farthest_m);
    this.camera.position.copy(target).add(offset);
    this.controls.target.copy(target);
    this.controls.update();
    this.redraw();
  }

  look(from: 'oblique' | 'top'): void {
    const centre = this.content.localToWorld(this.box.getCenter(new Vector3()));
    const size = this.box.getSize(new Vector3());
    const extent = Math.max(size.x, size.y / Math.max(0.5, this.camera.aspect), 5);
    const distance = (0.7 * extent) / Math.tan((this.camera.fov * Math.PI) / 360) / Math.max(0.6, Math.min(1.4, this.camera.aspect));
    const direction = from === 'top' ? new Vector3(0, -0.0001, 1) : new Vector3(-0.5, -1, 0.85).normalize();
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(direction, distance);
    this.controls.update();
    this.redraw();
  }

  applyTheme(): void {
    this.scene.background = new Color(isDark() ? '#15181c' : '#fbfbfa');
    this.points.applyTheme();
    this.surface.applyTheme();
    this.lines.applyTheme();
    this.redraw();
  }

  /** The position of a line on the canvas in CSS pixels; for tests. */
  screenPositionOf(line: number): [number, number] | null {
    const middle = this.lines.middleOf(line);
    const at = middle && this.toScreen(middle);
    return at ? [at[0], at[1]] : null;
  }

  redraw(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.render());
  }

  private fill(patch: Patch, method: Method): void {
    this.points.show(patch.points, planeColours(method));
    this.planes.show(method);
    this.lines.show(method.lines);
  }

  private thin(share: number): void {
    this.share = share;
    this.points.thin(share);
    this.surface.thin(share);
  }

  /** While the view turns, points are thinned until 30 frames per second are reached. */
  private keepFluent(): void {
    const now = performance.now();
    const took_ms = now - this.lastFrame;
    if (this.lastFrame > 0 && took_ms < 1000) {
      if (took_ms > 34) this.thin(Math.max(0.05, 0.6 * this.share));
      else if (took_ms < 20) this.thin(Math.min(1, 1.1 * this.share));
    }
    this.lastFrame = now;
  }

  private render(): void {
    this.frame = 0;
    ++this.nFrames;
    if (this.isMoving) this.keepFluent();
    this.renderer.render(this.scene, this.camera);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.element;
    if (clientWidth === 0 || clientHeight === 0) return;
    [this.width, this.height] = [clientWidth, clientHeight];
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.lines.setResolution(clientWidth, clientHeight);
    this.measure.setResolution(clientWidth, clientHeight);
    this.render();
  }

  /** Finds the box of the LIDAR points or, without them, of the surface; without any points, the
   * box of the lines except the farthest ones. */
  private findBox(patch: Patch, method: Method): void {
    this.box.makeEmpty();
    const points = patch.points ?? patch.surface;
    if (points) {
      const { low, step } = points;
      this.box.expandByPoint(new Vector3(...low));
      this.box.expandByPoint(new Vector3(...(low.map((v, a) => v + 65535 * step[a]!) as Triple)));
      return;
    }
    const axis = (a: number): number[] => method.lines.flatMap((l) => (l.start && l.end ? [l.start[a]!, l.end[a]!] : [])).sort((x, y) => x - y);
    const range = [0, 1, 2].map((a) => { const v = axis(a); return [v[Math.floor(0.02 * v.length)] ?? 0, v[Math.floor(0.98 * (v.length - 1))] ?? 1] as const; });
    this.box.expandByPoint(new Vector3(range[0]![0], range[1]![0], range[2]![0]));
    this.box.expandByPoint(new Vector3(range[0]![1], range[1]![1], range[2]![1]));
  }

  /** Pixels and depth of a point; null if the camera does not see it. */
  private toScreen(x: Vector3): [number, number, number] | null {
    const p = this.content.localToWorld(x.clone()).project(this.camera);
    return p.z > 1 || p.z < -1 ? null : [((p.x + 1) / 2) * this.width, ((1 - p.y) / 2) * this.height, p.z];
  }

  /** The point nearest to the eye among all points shown near a screen position. */
  private pointNear(at: [number, number], project: (x: Vector3) => [number, number, number] | null): Vector3 | null {
    const near = [this.points, this.surface].flatMap((layer) => layer.pointNear(at, project) ?? []);
    return near.sort((a, b) => a.depth - b.depth)[0]?.x ?? null;
  }

  private listenForClicks(canvas: HTMLCanvasElement): void {
    let down: [number, number] | null = null;
    canvas.addEventListener('pointerdown', (e) => { down = e.button === 0 ? [e.offsetX, e.offsetY] : null; });
    canvas.addEventListener('pointerup', (e) => {
      if (!down || Math.hypot(e.offsetX - down[0], e.offsetY - down[1]) > 4) return;
      const at: [number, number] = [e.offsetX, e.offsetY];
      const project = (x: Vector3): [number, number, number] | null => this.toScreen(x);
      if (this.measure.isOn) {
        const x = this.lines.pointNear(at, project) ?? this.pointNear(at, project);
        if (x) this.measure.add(x);
        this.redraw();
      } else {
        this.onPick(this.lines.nearest(at, project));
      }
    });
  }
}

// SPDX-License-Identifier: BSD-3-Clause
import { Color, Group, Vector3 } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { classColour, distanceColour, selectionColour, statusColour } from '../data/colours';
import type { Line } from '../data/schema';

export type LineColouring = 'class' | 'status' | 'distance';
/** Returns the screen position of a point and its depth; null if it is not visible. */
type Project = (x: Vector3) => [number, number, number] | null;

const colourOf: Record<LineColouring, (line: Line) => string> = {
  class: (line) => classColour(line.class),
  status: (line) => statusColour(line.status),
  distance: distanceColour,
};

/** Lines lie among the points against which they were judged; the offset towards the eye keeps them
 * visible. */
function layer(width: number, dashed: boolean): LineSegments2 {
  const material = new LineMaterial({ linewidth: width, vertexColors: true, dashed, dashSize: 0.6, gapSize: 0.4,
    polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -600 });
  const object = new LineSegments2(new LineSegmentsGeometry(), material);
  object.frustumCulled = false;
  return object;
}

/** Evaluated lines are solid, others dashed. Aligned lines are thicker, so that they can be
 * distinguished in print without colour. The selected line is drawn on top of everything. */
export class LineLayer {
  readonly object = new Group();
  private readonly parts: readonly { object: LineSegments2; has: (line: Line) => boolean }[] = [true, false].flatMap((aligned) =>
    [true, false].map((evaluated) => ({
      object: layer(aligned ? 4 : 2, !evaluated),
      has: (line: Line) => (line.class === 'aligned') === aligned && (line.status === 'evaluated') === evaluated,
    })));
  private readonly selected = layer(6, false);
  private lines: readonly Line[] = [];
  private colouring: LineColouring = 'class';
  private chosen: number | null = null;

  constructor() {
    this.selected.material.depthTest = false;
    this.selected.renderOrder = 2;
    this.object.add(...this.parts.map((part) => part.object), this.selected);
  }

  show(lines: readonly Line[]): void {
    this.lines = lines;
    this.applyTheme();
    this.select(null);
  }

  colourBy(colouring: LineColouring): void {
    this.colouring = colouring;
    this.applyTheme();
  }

  applyTheme(): void {
    for (const { object, has } of this.parts) this.fill(object, this.lines.filter(has), colourOf[this.colouring]);
  }

  select(line: number | null): void {
    this.chosen = line;
    const chosen = this.chosen === null ? [] : this.lines.slice(this.chosen, this.chosen + 1);
    this.fill(this.selected, chosen, () => selectionColour);
  }

  setResolution(width: number, height: number): void {
    for (const object of [...this.parts.map((part) => part.object), this.selected]) object.material.resolution.set(width, height);
  }

  planesOf(line: number): number[] {
    return this.lines[line]?.planes.map((p) => p.id) ?? [];
  }

  middleOf(line: number): Vector3 | null {
    const l = this.lines[line];
    return l?.start && l.end ? new Vector3(...l.start).add(new Vector3(...l.end)).multiplyScalar(0.5) : null;
  }

  /** The line nearest to a screen position, within 8 pixels. */
  nearest(at: [number, number], project: Project): number | null {
    return this.search(at, project)?.line ?? null;
  }
  pointNear(at: [number, number], project: Project): Vector3 | null {
    return this.search(at, project)?.x ?? null;
  }

  private search(at: [number, number], project: Project): { line: number; x: Vector3 } | null {
    let best = 8;
    let found: { line: number; x: Vector3 } | null = null;
    this.lines.forEach((line, i) => {
      if (!line.start || !line.end) return;
      const start = new Vector3(...line.start);
      const end = new Vector3(...line.end);
      const [a, b] = [project(start), project(end)];
      if (!a || !b) return;
      const squared = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2;
      const t = squared > 0 ? Math.min(1, Math.max(0, ((at[0] - a[0]) * (b[0] - a[0]) + (at[1] - a[1]) * (b[1] - a[1])) / squared)) : 0;
      const d = Math.hypot(at[0] - a[0] - t * (b[0] - a[0]), at[1] - a[1] - t * (b[1] - a[1]));
      if (d < best) [best, found] = [d, { line: i, x: start.lerp(end, t) }];
    });
    return found;
  }

  private fill(object: LineSegments2, lines: readonly Line[], colour: (line: Line) => string): void {
    const drawn = lines.filter((l) => l.start && l.end);
    object.visible = drawn.length > 0;
    object.geometry.dispose();
    object.geometry = new LineSegmentsGeometry();
    if (drawn.length === 0) return;
    object.geometry.setPositions(drawn.flatMap((l) => [...l.start!, ...l.end!]));
    const value = new Color();
    object.geometry.setColors(drawn.flatMap((l) => { const c = value.set(colour(l)).toArray(); return [...c, ...c]; }));
    if (object.material.dashed) object.computeLineDistances();
  }
}

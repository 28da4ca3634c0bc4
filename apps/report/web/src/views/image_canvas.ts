// SPDX-License-Identifier: BSD-3-Clause
// An image with an overlay, which can be zoomed and panned.
import type { Point2 } from '../data/geometry';
import type { ImageSegment } from '../data/schema';
import { h } from '../ui/dom';

export interface Stroke {
  colour: string;
  width: number; // screen pixels
  dash?: number[];
  halo?: boolean;
}

export class ImageCanvas {
  readonly canvas: HTMLCanvasElement;
  private readonly context: CanvasRenderingContext2D;
  private scale = 0; // screen pixels per image pixel; 0: fit
  private centre: Point2;
  private moved = false;
  // cached size of the canvas on the page: reading it for every segment would force a new layout
  private width = 1;
  private height = 1;

  /** `paint` draws the overlay; `click` receives the image coordinates of a click and its reach in
   * image pixels. */
  constructor(
    private readonly picture: HTMLImageElement,
    private readonly size: Point2,
    label: string,
    private readonly paint: (canvas: ImageCanvas) => void,
    click?: (x: Point2, reach_px: number) => void,
  ) {
    this.canvas = h('canvas', { class: 'image', 'aria-label': label, role: 'img', tabindex: click ? 0 : undefined });
    this.context = this.canvas.getContext('2d')!;
    this.centre = [size[0] / 2, size[1] / 2];
    if (click) this.listen(click);
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  private fitScale(): number {
    return Math.min(this.width / this.size[0], this.height / this.size[1]) || 1;
  }
  private get pxPerPixel(): number {
    return this.scale > 0 ? this.scale : this.fitScale();
  }
  /** (0, 0) is the centre of the first pixel. */
  private toScreen([x, y]: Point2): Point2 {
    const s = this.pxPerPixel;
    return [(x + 0.5 - this.centre[0]) * s + this.width / 2, (y + 0.5 - this.centre[1]) * s + this.height / 2];
  }
  private toImage([x, y]: Point2): Point2 {
    const s = this.pxPerPixel;
    return [(x - this.width / 2) / s + this.centre[0] - 0.5, (y - this.height / 2) / s + this.centre[1] - 0.5];
  }

  private listen(click: (x: Point2, reach_px: number) => void): void {
    const c = this.canvas;
    let last: Point2 | null = null;
    c.addEventListener('pointerdown', (e) => { last = [e.offsetX, e.offsetY]; this.moved = false; c.setPointerCapture(e.pointerId); });
    c.addEventListener('pointermove', (e) => {
      if (!last) return;
      const [dx, dy] = [e.offsetX - last[0], e.offsetY - last[1]];
      if (!this.moved && Math.hypot(dx, dy) < 4) return;
      this.moved = true;
      this.centre = [this.centre[0] - dx / this.pxPerPixel, this.centre[1] - dy / this.pxPerPixel];
      last = [e.offsetX, e.offsetY];
      this.draw();
    });
    c.addEventListener('pointerup', (e) => {
      if (last && !this.moved) click(this.toImage([e.offsetX, e.offsetY]), 8 / this.pxPerPixel);
      last = null;
    });
    c.addEventListener('dblclick', () => this.fit());
    c.addEventListener('wheel', (e) => {
      e.preventDefault();
      this.zoom(Math.exp(-e.deltaY * 0.0015), [e.offsetX, e.offsetY]);
    }, { passive: false });
    c.addEventListener('keydown', (e) => {
      if (e.key === '+' || e.key === '=') this.zoom(1.25);
      else if (e.key === '-') this.zoom(0.8);
      else if (e.key === '0') this.fit();
      else return;
      e.preventDefault();
    });
  }

  private zoom(factor: number, at: Point2 = [this.width / 2, this.height / 2]): void {
    const before = this.toImage(at);
    this.scale = Math.min(40, Math.max(0.5 * this.fitScale(), this.pxPerPixel * factor));
    const after = this.toImage(at);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
    this.draw();
  }

  fit(): void {
    this.scale = 0;
    this.centre = [this.size[0] / 2, this.size[1] / 2];
    this.draw();
  }

  /** Zooms to a segment with its surroundings. */
  frame([x1, y1, x2, y2]: ImageSegment): void {
    const margin = 30;
    [this.width, this.height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    this.centre = [(x1 + x2) / 2 + 0.5, (y1 + y2) / 2 + 0.5];
    const wanted = Math.min(this.width / (Math.abs(x2 - x1) + 2 * margin), this.height / (Math.abs(y2 - y1) + 2 * margin));
    this.scale = Math.min(6, Math.max(this.fitScale(), wanted));
    this.draw();
  }

  draw(): void {
    const c = this.canvas;
    const ratio = devicePixelRatio || 1;
    [this.width, this.height] = [c.clientWidth, c.clientHeight];
    const width = Math.round(this.width * ratio);
    const height = Math.round(this.height * ratio);
    if (width === 0 || height === 0) return;
    if (c.width !== width || c.height !== height) [c.width, c.height] = [width, height];
    const s = this.pxPerPixel;
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.context.clearRect(0, 0, this.width, this.height);
    this.context.imageSmoothingEnabled = s < 3;
    const [x, y] = this.toScreen([-0.5, -0.5]);
    if (this.picture.complete && this.picture.naturalWidth > 0) this.context.drawImage(this.picture, x, y, this.size[0] * s, this.size[1] * s);
    this.paint(this);
  }

  segment([x1, y1, x2, y2]: ImageSegment, stroke: Stroke): void {
    this.curve([[x1, y1], [x2, y2]], stroke);
  }

  curve(points: readonly Point2[], stroke: Stroke): void {
    const g = this.context;
    const [first, ...rest] = points.map((x) => this.toScreen(x));
    if (!first || ![first, ...rest].flat().every((v) => Number.isFinite(v) && Math.abs(v) < 1e5)) return;
    const line = (style: string, width: number, dash: number[]): void => {
      g.strokeStyle = style;
      g.lineWidth = width;
      g.setLineDash(dash);
      g.beginPath();
      g.moveTo(...first);
      for (const x of rest) g.lineTo(...x);
      g.stroke();
    };
    if (stroke.halo) line('#ffffffc0', stroke.width + 3, []);
    line(stroke.colour, stroke.width, stroke.dash ?? []);
  }
}

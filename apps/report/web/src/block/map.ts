// SPDX-License-Identifier: BSD-3-Clause
// The sheet on which plans are drawn: north is up, and all layers cover the same box. Points and
// lines are drawn on canvases, the rest is SVG.
import { distanceSteps, isDark, okabeIto } from '../data/colours';
import { uint16, uint8 } from '../data/decode';
import { h } from '../ui/dom';
import { svg } from '../ui/svg';
import { roundLength } from '../ui/round_length';
import type { Box, PlanLines, Relief, Steps } from './schema';

const notJudged = 65535;
const sharpness = 2; // canvas pixels per unit of the drawing

export class Sheet {
  readonly width: number;
  readonly height: number;
  readonly scale: number; // units of the drawing per metre
  readonly relief: HTMLCanvasElement;
  readonly lines: HTMLCanvasElement;
  readonly drawing: SVGElement;
  readonly element: HTMLElement;

  constructor(readonly box: Box, label: string, width: number, mostHeight: number) {
    const [left, bottom, right, top] = box;
    this.scale = Math.min(width / (right - left), mostHeight / (top - bottom));
    this.width = (right - left) * this.scale;
    this.height = (top - bottom) * this.scale;
    this.relief = this.canvas('relief');
    this.lines = this.canvas('lines');
    this.drawing = svg('svg', { viewBox: `0 0 ${this.width} ${this.height}`, role: 'group', 'aria-label': label });
    this.element = h('div', { class: 'sheet' }, this.relief, this.drawing, this.lines);
    this.element.style.aspectRatio = `${this.width} / ${this.height}`;
    this.element.style.maxWidth = `${this.width}px`;
  }

  at(x: number, y: number): [number, number] {
    return [(x - this.box[0]) * this.scale, this.height - (y - this.box[1]) * this.scale];
  }

  private canvas(name: string): HTMLCanvasElement {
    return h('canvas', { class: name, width: Math.round(this.width * sharpness), height: Math.round(this.height * sharpness), 'aria-hidden': 'true' });
  }

  /** A cleared canvas, to be drawn on in units of the drawing. */
  contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
    const context = canvas.getContext('2d')!;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.scale(canvas.width / this.width, canvas.height / this.height);
    return context;
  }

  private inSteps([x, y, dx, dy]: Steps): (numbers: Uint16Array, i: number) => [number, number] {
    return (numbers, i) => this.at(x + dx * numbers[i]!, y + dy * numbers[i + 1]!);
  }

  /** Draws points as grey squares as large as the spacing of the points; null draws none. */
  drawRelief(relief: Relief | null): void {
    const context = this.contextOf(this.relief);
    if (!relief) return;
    const places = uint16(relief.places);
    const greys = uint8(relief.greys);
    const at = this.inSteps(relief.steps);
    const size = Math.min(6, Math.max(0.7, 1.1 * Math.sqrt((this.width * this.height) / relief.n_shown)));
    const byGrey: [number, number][][] = Array.from({ length: 32 }, () => []);
    greys.forEach((grey, i) => byGrey[grey >> 3]!.push(at(places, 2 * i)));
    byGrey.forEach((points, k) => {
      const level = isDark() ? 30 + 4 * k : 165 + 2.6 * k;
      context.fillStyle = `rgb(${level} ${level} ${level})`;
      for (const [x, y] of points) context.fillRect(x - size / 2, y - size / 2, size, size);
    });
  }

  /** Draws the lines with distances above `from_m`, the worst on top; if it is null, all lines,
   * including those not judged. */
  drawLines(lines: PlanLines | null, from_m: number | null, width: number): void {
    const context = this.contextOf(this.lines);
    if (!lines) return;
    const ends = uint16(lines.ends);
    const distances = uint16(lines.distances_mm);
    const at = this.inSteps(lines.steps);
    const draw = (colour: string, weight: number, has: (mm: number) => boolean): void => {
      context.beginPath();
      distances.forEach((mm, i) => {
        if (!has(mm)) return;
        context.moveTo(...at(ends, 4 * i));
        context.lineTo(...at(ends, 4 * i + 2));
      });
      context.strokeStyle = colour;
      context.lineWidth = weight;
      context.stroke();
    };
    context.lineCap = 'round';
    if (from_m === null) draw(okabeIto.grey, 0.6 * width, (mm) => mm === notJudged);
    let above = 0;
    for (const step of distanceSteps) {
      const upTo = Math.min(1000 * step.upTo_m, notJudged - 1);
      const least = above;
      if (from_m === null || upTo > 1000 * from_m) {
        const has = (mm: number): boolean => mm <= upTo && (mm > least || least === 0);
        if (from_m !== null) draw('#ffffff', 2 * width, has); // a white seam, for dark squares
        draw(step.colour, width, has);
      }
      above = upTo;
    }
  }

  /** Scale bar and north arrow, to be placed below the sheet. */
  foot(): HTMLElement {
    const length_m = roundLength(0.25 * (this.box[2] - this.box[0]));
    const bar = length_m * this.scale;
    const height = 30;
    const text = length_m >= 1000 ? `${length_m / 1000} km` : `${length_m} m`;
    const foot = h('div', { class: 'sheet-foot' });
    foot.style.maxWidth = `${this.width}px`;
    foot.append(svg('svg', { viewBox: `0 0 ${this.width} ${height}`, role: 'img', 'aria-label': `Scale bar of ${text}; north is up` },
      svg('path', { d: `M 1 6 v 7 h ${bar} v -7`, class: 'ink' }),
      svg('text', { x: bar + 10, y: 17 }, text),
      svg('path', { d: `M ${this.width - 12} 3 l 6 20 l -6 -5 l -6 5 z`, class: 'north' }),
      svg('text', { x: this.width - 24, y: 20, 'text-anchor': 'end' }, 'N')));
    return foot;
  }
}

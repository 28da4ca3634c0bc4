// SPDX-License-Identifier: BSD-3-Clause
// The plan of the edges, coloured by kind, on the shaded roof planes.
import { Sheet } from '../block/map';
import { isDark, selectionColour } from '../data/colours';
import { checkbox, h, replace } from '../ui/dom';
import { kindColour } from './kind_colours';
import type { EdgeRow, EdgesReport, PlaneRow } from './schema';

/** The grey of a plane lit from the north-west, 45 degrees above the horizon. */
function shadeOf({ slope_deg, aspect_deg }: PlaneRow): string {
  const slope = (slope_deg * Math.PI) / 180;
  const facing = aspect_deg === null ? 0 : Math.cos(((aspect_deg - 315) * Math.PI) / 180);
  const light = Math.SQRT1_2 * (Math.cos(slope) + Math.sin(slope) * facing);
  const level = isDark() ? 40 + 70 * light : 150 + 90 * light;
  return `rgb(${level} ${level} ${level})`;
}

export class EdgePlan {
  readonly element = h('section', { id: 'plan' });
  private readonly sheet: Sheet;
  private readonly shown: Set<string>;
  private marked: string | null = null;

  constructor(private readonly report: EdgesReport) {
    this.shown = new Set(report.kinds.map((row) => row.kind));
    this.sheet = new Sheet(report.box, 'Plan of the edges and roof planes', 1100, 900);
    const kinds = report.kinds.filter((row) => row.kind !== 'total' && row.n > 0);
    replace(this.element, h('h2', {}, 'Plan'),
      h('div', { class: 'controls' }, ...kinds.map(({ kind }) => this.switchOf(kind))),
      this.sheet.element, this.sheet.foot(),
      h('p', { class: 'caption' }, `Edges by kind on the roof planes, which are lit from the north-west. Coordinates from ${report.origin_m[0]}, ${report.origin_m[1]}.`));
    this.draw();
  }

  private switchOf(kind: string): HTMLElement {
    const box = checkbox(kind, true, (on) => {
      if (on) this.shown.add(kind);
      else this.shown.delete(kind);
      this.draw();
    });
    const swatch = h('span', { class: 'kind-swatch', 'aria-hidden': 'true' });
    swatch.style.background = kindColour(kind);
    box.append(swatch);
    return box;
  }

  mark(id: string | null): void {
    this.marked = id;
    this.draw();
  }

  /** Redraws everything; also called after a change of theme. */
  draw(): void {
    this.drawPlanes();
    const g = this.sheet.contextOf(this.sheet.lines);
    g.lineCap = 'round';
    for (const edge of this.report.edges) {
      if (this.shown.has(edge[1])) this.drawEdge(g, edge, kindColour(edge[1]), 2);
    }
    for (const edge of this.report.edges) {
      if (edge[0] === this.marked) this.drawEdge(g, edge, selectionColour, 5);
    }
  }

  private drawPlanes(): void {
    const g = this.sheet.contextOf(this.sheet.relief);
    for (const plane of this.report.planes) {
      g.beginPath();
      for (const ring of plane.rings) {
        for (let i = 0; i < ring.length; i += 2) {
          const at = this.sheet.at(ring[i]!, ring[i + 1]!);
          if (i === 0) g.moveTo(...at);
          else g.lineTo(...at);
        }
        g.closePath();
      }
      g.fillStyle = shadeOf(plane);
      g.fill('evenodd');
    }
  }

  private drawEdge(g: CanvasRenderingContext2D, [, , x0, y0, x1, y1]: EdgeRow, colour: string, width: number): void {
    g.beginPath();
    g.moveTo(...this.sheet.at(x0, y0));
    g.lineTo(...this.sheet.at(x1, y1));
    g.strokeStyle = colour;
    g.lineWidth = width;
    g.stroke();
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// The lines of a method in plan, coloured by distance, with scale and legend, as a printable
// drawing.
import { distanceColour, distanceSteps, okabeIto, selectionColour } from '../data/colours';
import type { Line, Method, Patch } from '../data/schema';
import type { State } from '../state';
import { h, replace } from '../ui/dom';
import { svg } from '../ui/svg';
import { drawnLines, planFrame, swatch } from './plan_frame';

export class Plan {
  readonly element = h('figure', { id: 'plan' });
  private drawn = new Map<number, SVGElement>();

  constructor(private readonly state: State) {}

  show(patch: Patch, method: Method): void {
    this.drawn = new Map();
    const shown = drawnLines(method.lines);
    if (shown.length === 0) {
      replace(this.element);
      return;
    }
    const { drawing, content, at } = planFrame(shown.map(({ line }) => line), `Lines of patch ${patch.id} in plan, coloured by distance`);
    // the worst are drawn last, on top of the others
    for (const { line, index } of [...shown].sort((a, b) => (a.line.mean_distance_m ?? -1) - (b.line.mean_distance_m ?? -1))) {
      content.append(this.drawLine(line, index, at(line.start!), at(line.end!)));
    }
    const legend = h('p', { class: 'legend' }, ...distanceSteps.map((s) => swatch(s.colour, s.text)), swatch(okabeIto.grey, 'not judged'));
    replace(this.element, h('figcaption', {}, h('strong', {}, `Lines in plan: patch ${patch.id}, ${method.name}`), '. Colour: mean distance from the LIDAR planes. North is up.'), legend);
    this.element.insertBefore(drawing, legend);
  }

  select(line: number | null): void {
    for (const [index, element] of this.drawn) {
      const isChosen = index === line;
      element.classList.toggle('chosen', isChosen);
      element.setAttribute('stroke', isChosen ? selectionColour : distanceColour(this.state.method.lines[index]!));
    }
  }

  private drawLine(line: Line, index: number, a: [number, number], b: [number, number]): SVGElement {
    const isJudged = line.mean_distance_m !== null;
    const distance = isJudged ? `${line.mean_distance_m!.toFixed(3)} m` : line.status;
    const element = svg('line', { x1: a[0], y1: a[1], x2: b[0], y2: b[1], stroke: distanceColour(line), 'stroke-width': isJudged ? 2.2 : 1.2, ...(isJudged ? {} : { 'stroke-dasharray': '4 3' }) },
      svg('title', {}, `${line.id}: ${distance}`));
    element.addEventListener('click', () => this.state.set({ line: index }));
    this.drawn.set(index, element);
    return element;
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// The buildings of a model in plan, their edges coloured by verdict, the worst ones numbered as in
// the list.
import type { Line } from '../data/schema';
import { lookOf, verdicts, worstBuildings } from '../data/verdicts';
import type { State } from '../state';
import { h } from '../ui/dom';
import { svg } from '../ui/svg';
import { drawnLines, planFrame, swatch } from './plan_frame';

const numbered = 12;

export class BuildingPlan {
  readonly element = h('figure', { id: 'building-plan' });

  constructor(private readonly state: State) {
    const { buildings = [], lines } = state.method;
    const shown = drawnLines(lines);
    if (shown.length === 0) return;
    const verdictOf = new Map(buildings.map((b) => [b.id, b.verdict]));
    const { drawing, content, at } = planFrame(shown.map(({ line }) => line), 'Buildings in plan, coloured by verdict');
    const place = (line: Line): number => verdicts.indexOf(verdictOf.get(line.building ?? '') ?? 'not judged');
    // the worst are drawn last, on top of the others
    for (const { line, index } of [...shown].sort((a, b) => place(b.line) - place(a.line))) {
      content.append(this.drawEdge(line, index, verdictOf.get(line.building ?? '') ?? 'not judged', at));
    }
    worstBuildings(buildings).slice(0, numbered).forEach((building, i) => {
      const edges = shown.filter(({ line }) => line.building === building.id);
      if (edges.length === 0) return;
      const mean = (axis: 0 | 1): number => edges.reduce((sum, { line }) => sum + (line.start![axis] + line.end![axis]) / 2, 0) / edges.length;
      const [x, y] = at([mean(0), mean(1)]);
      content.append(svg('text', { x, y, 'text-anchor': 'middle' }, String(i + 1)));
    });
    const present = verdicts.filter((verdict) => buildings.some((b) => b.verdict === verdict));
    this.element.append(h('figcaption', {}, h('strong', {}, `Buildings in plan: ${state.method.name}`), '. Colour and dashes: verdict; numbers: the worst buildings, as in the sections below.'),
      drawing, h('p', { class: 'legend' }, ...present.map((verdict) => swatch(lookOf(verdict).colour, verdict, lookOf(verdict).dash !== undefined))));
  }

  private drawEdge(line: Line, index: number, verdict: string, at: (x: readonly number[]) => [number, number]): SVGElement {
    const [a, b] = [at(line.start!), at(line.end!)];
    const { colour, dash } = lookOf(verdict);
    const element = svg('line', { x1: a[0], y1: a[1], x2: b[0], y2: b[1], stroke: colour, 'stroke-width': verdict === 'right' ? 1.2 : 2.2, ...(dash ? { 'stroke-dasharray': dash } : {}) },
      svg('title', {}, `${line.building ?? ''}: ${verdict}`));
    element.addEventListener('click', () => this.state.set({ line: index }));
    return element;
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// The lines of a method in plan, coloured by distance, with scale and legend; a drawing that prints.
import { distanceColour, distanceSteps, okabeIto, selectionColour } from '../data/colours';
import type { Line, Method, Patch } from '../data/schema';
import type { State } from '../state';
import { h, replace } from '../ui/dom';
import { roundLength } from '../ui/round_length';
import { svg } from '../ui/svg';

interface Box { left: number; bottom: number; width: number; height: number }

/** The box around the lines, except the few that lie far from all others. */
function boxOf(lines: readonly Line[]): Box {
  const range = (axis: 0 | 1): [number, number] => {
    const values = lines.flatMap((l) => [l.start![axis], l.end![axis]]).sort((a, b) => a - b);
    const at = (share: number): number => values[Math.round(share * (values.length - 1))]!;
    const [low, high] = [at(0.01), at(0.99)];
    const slack = 0.5 * (high - low) + 1;
    return [Math.max(values[0]!, low - slack), Math.min(values[values.length - 1]!, high + slack)];
  };
  const [x, y] = [range(0), range(1)];
  const margin = 0.03 * Math.max(x[1] - x[0], y[1] - y[0], 1);
  return { left: x[0] - margin, bottom: y[0] - margin, width: x[1] - x[0] + 2 * margin, height: y[1] - y[0] + 2 * margin };
}

export class Plan {
  readonly element = h('figure', { id: 'plan' });
  private drawn = new Map<number, SVGElement>();

  constructor(private readonly state: State) {}

  show(patch: Patch, method: Method): void {
    this.drawn = new Map();
    const shown = method.lines.map((line, index) => ({ line, index })).filter(({ line }) => line.start && line.end);
    if (shown.length === 0) {
      replace(this.element);
      return;
    }
    const box = boxOf(shown.map(({ line }) => line));
    const width = 640;
    const scale = width / box.width;
    const height = Math.min(760, Math.max(200, box.height * scale));
    const at = (x: readonly number[]): [number, number] => [(x[0]! - box.left) * scale, height - (x[1]! - box.bottom) * scale];
    const drawing = svg('svg', { viewBox: `0 0 ${width} ${height + 34}`, role: 'img', 'aria-label': `Lines of patch ${patch.id} in plan, coloured by distance` });
    const clip = svg('g', {});
    // the worst are drawn last, over the others
    for (const { line, index } of [...shown].sort((a, b) => (a.line.mean_distance_m ?? -1) - (b.line.mean_distance_m ?? -1))) {
      clip.append(this.drawLine(line, index, at(line.start!), at(line.end!)));
    }
    drawing.append(svg('rect', { x: 0.5, y: 0.5, width: width - 1, height: height - 1, class: 'frame' }), clip, this.scaleBar(scale, box.width, height));
    const legend = h('p', { class: 'legend' }, ...distanceSteps.map((s) => this.swatch(s.colour, s.text)), this.swatch(okabeIto.grey, 'not judged'));
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

  private scaleBar(scale: number, width_m: number, y: number): SVGElement {
    const length_m = roundLength(0.25 * width_m);
    return svg('g', { class: 'scale-bar' }, svg('path', { d: `M 1 ${y + 10} v 6 h ${length_m * scale} v -6`, fill: 'none' }),
      svg('text', { x: length_m * scale + 8, y: y + 18 }, `${length_m} m`));
  }

  private swatch(colour: string, text: string): HTMLElement {
    const mark = h('span', { class: 'swatch', 'aria-hidden': 'true' });
    mark.style.background = colour;
    return h('span', { class: 'legend-item' }, mark, text);
  }
}

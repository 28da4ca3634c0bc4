// SPDX-License-Identifier: BSD-3-Clause
// The legends: the shades, each with its number of patches, and the colours of lines.
import { distanceSteps, okabeIto } from '../data/colours';
import { h } from '../ui/dom';
import { svg } from '../ui/svg';
import type { PatchRow } from './schema';
import { shadeColour, shadeOf, shadeText, stateOf, stateText, type Figure, type State } from './shades';
import { patterns } from './squares';

const patternSwatch = (state: State): SVGElement => svg('svg', { viewBox: '0 0 26 16', class: 'square-swatch', 'aria-hidden': 'true' }, patterns(),
  svg('g', { class: state }, svg('rect', { x: 0.5, y: 0.5, width: 25, height: 15 })));

function shadeSwatch(shade: number): SVGElement {
  return svg('svg', { viewBox: '0 0 26 16', class: 'square-swatch', 'aria-hidden': 'true' }, svg('rect', { x: 0.5, y: 0.5, width: 25, height: 15, fill: shadeColour(shade), class: 'rim' }));
}

const item = (swatch: Node, text: string, n: number): HTMLElement =>
  h('li', { class: n === 0 ? 'unused' : undefined }, swatch, h('span', {}, text), h('span', { class: 'number' }, String(n)));

export function shadeLegend(figure: Figure, patches: readonly PatchRow[], method: number): HTMLElement {
  const counts = figure.limits.map(() => 0).concat(0);
  const states: Record<State, number> = { failed: 0, empty: 0, none: 0 };
  for (const patch of patches) {
    const figures = patch.figures[method]!;
    const state = stateOf(figure, figures, patch.reason);
    if (state) ++states[state];
    else ++counts[shadeOf(figure, figure.value(figures)!)]!;
  }
  return h('div', { id: 'plan-legend' }, h('h3', {}, `${figure.name[0]!.toUpperCase()}${figure.name.slice(1)}`),
    h('p', { class: 'caption' }, `${figure.dark} Right: number of patches.`),
    h('ul', {}, ...counts.map((n, shade) => item(shadeSwatch(shade), shadeText(figure, shade), n)),
      ...(Object.keys(states) as State[]).filter((s) => states[s] > 0).map((s) => item(patternSwatch(s), stateText[s], states[s]))));
}

function swatch(colour: string, text: string): HTMLElement {
  const mark = h('span', { class: 'swatch', 'aria-hidden': 'true' });
  mark.style.background = colour;
  return h('span', { class: 'legend-item' }, mark, text);
}

/** `from_m`: the smallest distance that is drawn; null if all lines are drawn. */
export const lineLegend = (from_m: number | null): HTMLElement => h('p', { class: 'legend' },
  ...distanceSteps.filter((s) => from_m === null || s.upTo_m > from_m).map((s, i) => swatch(s.colour, from_m !== null && i === 0 ? `${from_m.toFixed(2)} – ${s.upTo_m} m` : s.text)),
  from_m === null ? swatch(okabeIto.grey, 'not judged') : null);

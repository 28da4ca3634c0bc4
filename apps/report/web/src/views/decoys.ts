// SPDX-License-Identifier: BSD-3-Clause
// How many deliberately moved lines pass as correct.
import type { DecoyFigure, Method } from '../data/schema';
import { h, table, type Column } from '../ui/dom';
import { missing, percent, words } from '../ui/format';

const columns: Column<DecoyFigure>[] = [
  { title: 'moved', cell: (d) => words(d.kind) },
  { title: 'by', number: true, cell: (d) => `${d.distance_m} m` },
  { title: 'lines', number: true, cell: (d) => String(d.n_lines) },
  { title: 'decoys', number: true, cell: (d) => String(d.n_decoys) },
  { title: 'within 0.2 m', number: true, hint: 'percent of the decoys', cell: (d) => `${percent(d.share)} %` },
  { title: '95 % interval', number: true, cell: (d) => (d.ci95 ? `${percent(d.ci95[0])} – ${percent(d.ci95[1])} %` : missing) },
  { title: 'not evaluated', number: true, hint: 'percent of the decoys', cell: (d) => `${percent(d.withheld_share)} %` },
];

export function decoys(method: Method): HTMLElement | null {
  if (!method.decoys?.length) return null;
  return h('details', {}, h('summary', {}, 'Would wrong lines be detected?'),
    h('p', { class: 'caption' }, `Lines of ${method.name} were moved on purpose and judged again; the table shows how many pass as correct. It does not show how many lines are wrong. `
      + 'Height: up and down. Across: in plan; a plane cannot detect a shift within itself, so many pass. Match: along the rays of the first image, as a false match would.'),
    table(columns, method.decoys));
}

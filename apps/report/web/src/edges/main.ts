// SPDX-License-Identifier: BSD-3-Clause
// Shows the page of the edges of a point cloud.
import { readData } from '../data/decode';
import { append, h, table } from '../ui/dom';
import { EdgePlan } from './plan';
import type { EdgesReport, KindRow } from './schema';
import { sectionsOf } from './sections';

const number = (value: number | null, decimals: number): string => (value === null ? '-' : value.toFixed(decimals));

function kindTable(report: EdgesReport): HTMLElement {
  return h('section', { id: 'kinds' }, h('h2', {}, 'Edges by kind'), table<KindRow>([
    { title: 'kind', cell: (row) => row.kind },
    { title: 'edges', number: true, cell: (row) => String(row.n) },
    { title: 'length m', number: true, cell: (row) => number(row.length_m, 1) },
    { title: 'sigma m', number: true, hint: 'standard deviation of the middle at right angles to the edge, median', cell: (row) => number(row.median_sigma_m, 3) },
  ], report.kinds),
  h('p', { class: 'caption' }, 'sigma: standard deviation of the middle at right angles to the edge, median.'));
}

const root = document.getElementById('app')!;
try {
  const report = readData<EdgesReport>(1);
  const plan = new EdgePlan(report);
  append(root,
    h('header', {}, h('h1', {}, `Edges of ${report.name}`),
      h('p', {}, `${report.n_edges} edges of ${report.n_planes} roof planes. ${report.crs}`)),
    ...report.notes.map((note) => h('p', { class: 'message' }, note)),
    kindTable(report), plan.element, sectionsOf(report, (id) => plan.mark(id)));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => plan.draw());
  document.documentElement.dataset['ready'] = 'true';
} catch (error) {
  append(root, h('p', { class: 'message' }, `The page cannot be shown: ${error instanceof Error ? error.message : String(error)}`));
  throw error;
}

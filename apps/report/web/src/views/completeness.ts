// SPDX-License-Identifier: BSD-3-Clause
// Which edges of the scan the lines have found.
import type { Completeness, CompletenessRow, Method } from '../data/schema';
import { h, table, type Column } from '../ui/dom';
import { missing, percent } from '../ui/format';

const areas: Record<string, string> = {
  stated: 'the given area',
  images: 'the ground that the first image shows',
  block: 'the area of the block',
  lines: 'the convex hull of the judged lines, 5 m wider',
};

function columns(rows: CompletenessRow[]): Column<CompletenessRow>[] {
  const ofLength = (kind: string, length: string): string => {
    const row = rows.find((r) => r.kind === kind && r.length === length);
    return row?.recall != null ? `${percent(row.recall)} %` : missing;
  };
  return [
    { title: 'edges', cell: (r) => r.kind },
    { title: 'in the scan', number: true, cell: (r) => String(r.n) },
    { title: 'found', number: true, cell: (r) => `${percent(r.recall)} %` },
    { title: '95 % interval', number: true, cell: (r) => (r.ci95 ? `${percent(r.ci95[0])} – ${percent(r.ci95[1])} %` : missing) },
    { title: 'of the length', number: true, hint: 'percent of the length that has lines beside it', cell: (r) => `${percent(r.recall_length)} %` },
    { title: '2–4 m', number: true, cell: (r) => ofLength(r.kind, '2-4') },
    { title: '4–8 m', number: true, cell: (r) => ofLength(r.kind, '4-8') },
    { title: 'above 8 m', number: true, cell: (r) => ofLength(r.kind, '8+') },
  ];
}

function facts(c: Completeness): string {
  const notShown = c.rows.find((r) => r.kind === 'all' && r.length === 'all')?.n_not_in_images ?? 0;
  return `Area: ${areas[c.area_from] ?? c.area_from}, ${(c.area_m2 / 1e4).toFixed(2)} ha. `
    + `${c.n_lines_without_edge} of ${c.n_lines} lines follow no edge of the scan; they may be right (markings, shadows).`
    + (notShown > 0 ? ` ${notShown} further edges are shown in fewer than two images and do not count.` : '');
}

export function completeness(method: Method): HTMLElement | null {
  const c = method.completeness;
  if (!c) return null;
  const rows = c.rows.filter((r) => r.length === 'all');
  return h('details', { open: '' }, h('summary', {}, 'Which edges of the scan are found?'),
    h('p', { class: 'caption' }, 'Edges of roofs in the LIDAR cloud, at least 2 m long. An edge is found if lines within 0.3 m and 5 degrees of it cover half of its length together. '
      + 'Not all edges of a scan are right, so perfect lines do not reach 100 %.'),
    table(columns(c.rows), rows),
    h('p', { class: 'caption' }, facts(c)));
}

// SPDX-License-Identifier: BSD-3-Clause
// The areas in which pooled results were judged: a plan with links to their pages, and a table.
import { distanceSteps } from '../data/colours';
import type { JudgedArea, Report } from '../data/schema';
import { h } from '../ui/dom';
import { metres } from '../ui/format';
import { SortedTable } from '../ui/sorted_table';
import { svg } from '../ui/svg';

const width = 640;

const name = (i: number): string => `area ${i + 1}`;

function linkTo(area: JudgedArea, i: number): string | HTMLElement {
  return area.page ? h('a', { href: area.page }, name(i)) : name(i);
}

function colourOf(rms_m: number | null): string {
  const step = rms_m === null ? undefined : distanceSteps.find((s) => rms_m <= s.upTo_m);
  return step?.colour ?? 'none';
}

function plan(areas: readonly JudgedArea[]): SVGElement {
  const of = (k: 0 | 1 | 2 | 3): number[] => areas.map((a) => a.bounds_m[k]);
  const left = Math.min(...of(0));
  const top = Math.max(...of(3));
  const scale = width / (Math.max(...of(2)) - left);
  const height = (top - Math.min(...of(1))) * scale;
  const tiles = areas.map((area, i) => {
    const [x, y] = [(area.bounds_m[0] - left) * scale, (top - area.bounds_m[3]) * scale];
    const w = (area.bounds_m[2] - area.bounds_m[0]) * scale;
    const d = (area.bounds_m[3] - area.bounds_m[1]) * scale;
    const tile = [
      svg('title', {}, `${name(i)}: ${area.n_lines} lines, RMS ${metres(area.rms_m)} m`),
      svg('rect', { x, y, width: w, height: d, fill: colourOf(area.rms_m), class: 'tile' }),
      svg('text', { x: x + w / 2, y: y + d / 2, class: 'tile-number' }, String(i + 1)),
    ];
    return area.page ? svg('a', { href: area.page }, ...tile) : svg('g', {}, ...tile);
  });
  return svg('svg', { viewBox: `-1 -1 ${width + 2} ${height + 2}`, role: 'group', 'aria-label': 'Plan of the areas' }, ...tiles);
}

export function areas(report: Report): HTMLElement | null {
  const rows = report.run.areas?.map((area, i) => ({ area, i }));
  if (!rows || rows.length === 0) return null;
  return h('section', { id: 'areas' }, h('h2', {}, 'Areas'),
    h('p', { class: 'caption' }, 'The lines were judged area by area. The figures on this page are of all of them; the maps and lists of lines to fix are in the folders of the areas.'),
    h('div', { class: 'columns' }, h('div', {}, plan(rows.map((r) => r.area))),
      new SortedTable([
        { key: 'area', title: 'area', value: (r) => r.i, cell: (r) => linkTo(r.area, r.i) },
        { key: 'lines', title: 'lines', number: true, value: (r) => r.area.n_lines },
        { key: 'judged', title: 'judged', number: true, value: (r) => r.area.n_evaluated },
        { key: 'rms', title: 'RMS m', number: true, value: (r) => r.area.rms_m, cell: (r) => metres(r.area.rms_m) },
      ], rows, { id: 'area-table', sortBy: 'rms', descending: true, limit: 20 }).element));
}

// SPDX-License-Identifier: BSD-3-Clause
// The buildings of a model: how many are right, their plan, a table that begins with the worst, and
// sections of the worst.
import type { Building } from '../data/schema';
import { reasonOf, verdicts } from '../data/verdicts';
import type { State } from '../state';
import { button, h } from '../ui/dom';
import { metres, missing, percent } from '../ui/format';
import { SortedTable, type SortedColumn } from '../ui/sorted_table';
import { buildingSections } from './building_sections';
import { BuildingPlan } from './building_plan';

const shownRows = 50;

function countsText(buildings: readonly Building[]): string {
  const counts = verdicts.map((verdict) => ({ verdict, n: buildings.filter((b) => b.verdict === verdict).length })).filter(({ n }) => n > 0);
  return `${buildings.length} buildings: ${counts.map(({ verdict, n }) => `${n} ${verdict}`).join(', ')}.`;
}

function columns(select: (line: string) => void): SortedColumn<Building>[] {
  const share = (value: number | null): string => (value === null ? missing : percent(value));
  return [
    { key: 'id', title: 'building', value: (b) => b.id },
    { key: 'verdict', title: 'verdict', value: (b) => b.verdict },
    { key: 'points', title: 'points, m', number: true, value: (b) => b.points_rms_m, cell: (b) => metres(b.points_rms_m), hint: 'RMS distance of its points from its nearest surface' },
    { key: 'rms', title: 'RMS, m', number: true, value: (b) => b.rms_m, cell: (b) => metres(b.rms_m), hint: 'of its lines' },
    { key: 'lines', title: 'lines', number: true, value: (b) => b.n_judged_lines, cell: (b) => `${b.n_judged_lines}/${b.n_lines}`, hint: 'judged / all' },
    { key: 'worst', title: 'worst line, m', number: true, value: (b) => b.worst_distance_m,
      cell: (b) => (b.worst_line === '' ? missing : button(metres(b.worst_distance_m), () => select(b.worst_line), { class: 'plain', title: `select line ${b.worst_line}` })) },
    { key: 'ridge', title: 'ridge, m', number: true, value: (b) => b.ridge_height_m, cell: (b) => metres(b.ridge_height_m), hint: 'height of its ridges, model minus scan' },
    { key: 'eave', title: 'eave, m', number: true, value: (b) => b.eave_height_m, cell: (b) => metres(b.eave_height_m), hint: 'height of its eaves, model minus scan' },
    { key: 'faces', title: 'faces', number: true, value: (b) => b.n_judged_faces, cell: (b) => `${b.n_judged_faces}/${b.n_faces}`, hint: 'judged / all' },
    { key: 'unexplained', title: 'unexplained, %', number: true, value: (b) => b.unexplained_share, cell: (b) => share(b.unexplained_share), hint: 'points above it on none of its planes' },
    { key: 'reason', title: 'reason', value: reasonOf },
  ];
}

/** Empty for lines that do not belong to a model. */
export function buildingsOf(state: State): HTMLElement[] {
  const { buildings, lines, name } = state.method;
  if (!buildings) return [];
  const select = (id: string): void => {
    const line = lines.findIndex((l) => l.id === id);
    if (line >= 0) state.set({ line });
  };
  const table = new SortedTable<Building>(columns(select), buildings, { id: 'buildings', sortBy: 'points', descending: true, limit: shownRows });
  return [
    h('h3', {}, `Buildings: ${name}`),
    h('p', { id: 'building-counts' }, countsText(buildings)),
    new BuildingPlan(state).element,
    table.element,
    ...buildingSections(state),
    h('p', { class: 'caption' }, 'faces.csv lists every face; the map judged.*.gpkg has buildings and faces as layers.'),
  ];
}

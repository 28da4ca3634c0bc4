// SPDX-License-Identifier: BSD-3-Clause
// The figures of a method as defined by ASPRS, NSSDA, GUM and ISO 19157.
import type { IsoMeasure, Method, Standards } from '../data/schema';
import { h, table, type Column } from '../ui/dom';
import { fixed, metres, missing, words } from '../ui/format';

type Named = Standards & { name: string };

const asprsColumns: Column<Named>[] = [
  { title: 'class', cell: (s) => words(s.name) },
  { title: 'n', number: true, hint: 'ridges and hips', cell: (s) => String(s.asprs.n) },
  { title: 'RMSE H', number: true, hint: 'including the error of the reference', cell: (s) => metres(s.asprs.rmse_horizontal_m) },
  { title: 'RMSE V', number: true, hint: 'including the error of the reference', cell: (s) => metres(s.asprs.rmse_vertical_m) },
  { title: 'RMSE 3D', number: true, cell: (s) => metres(s.asprs.rmse_3d_m) },
  { title: 'best class', number: true, hint: 'best class supported by the reference, which must be twice as accurate', cell: (s) => metres(s.asprs.best_class_m) },
  { title: 'flags', cell: (s) => [s.asprs.few_checkpoints ? 'fewer than 30' : '', s.asprs.biased ? 'bias' : ''].filter(Boolean).join(', ') || missing },
  { title: 'NSSDA H', number: true, hint: '1.7308 RMSE H, for at least 20 ridges', cell: (s) => metres(s.nssda.horizontal_m) },
  { title: 'NSSDA V', number: true, hint: '1.9600 RMSE V, for at least 20 ridges', cell: (s) => metres(s.nssda.vertical_m) },
];

const budgetColumns: Column<Named>[] = [
  { title: 'class', cell: (s) => words(s.name) },
  { title: 'laser, random', number: true, cell: (s) => metres(s.uncertainty.laser_random_m) },
  { title: 'laser, systematic', number: true, cell: (s) => metres(s.uncertainty.laser_systematic_m) },
  { title: 'plane fit', number: true, cell: (s) => metres(s.uncertainty.plane_fit_m) },
  { title: 'combined u', number: true, cell: (s) => metres(s.uncertainty.combined_m) },
  { title: 'U = 2u', number: true, cell: (s) => metres(s.uncertainty.expanded_m) },
  { title: 'sampling of the RMS', number: true, cell: (s) => metres(s.uncertainty.sampling_m) },
];

const measureValue = (m: IsoMeasure): string => fixed(m.value, m.unit === 'count' ? 0 : 4);

const measureColumns: Column<IsoMeasure>[] = [
  { title: 'id', number: true, cell: (m) => String(m.id) },
  { title: 'measure', cell: (m) => m.name },
  { title: 'value', number: true, cell: measureValue },
  { title: 'unit', cell: (m) => m.unit },
  { title: 'n', number: true, cell: (m) => String(m.n) },
];

export function standards(method: Method): HTMLElement[] {
  if (!method.standards) return [];
  const rows = Object.entries(method.standards).map(([name, value]) => ({ ...value, name }));
  const { total } = method.standards;
  return [h('details', { id: 'standards' }, h('summary', {}, 'In terms of standards'),
    h('p', { class: 'caption' }, 'Metres. Informative: no conformity with a standard is claimed.'),
    h('h4', {}, 'ASPRS Edition 2 and, separately, NSSDA at 95 %'), table(asprsColumns, rows, { id: 'asprs' }),
    h('h4', {}, 'Uncertainty of the distance of one line (GUM)'), table(budgetColumns, rows, { id: 'budget' }),
    ...(total ? [h('h4', {}, 'ISO 19157 measures of all lines'), table(measureColumns, total.iso19157, { id: 'iso19157' })] : []))];
}

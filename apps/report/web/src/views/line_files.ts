// SPDX-License-Identifier: BSD-3-Clause
// Shows several line files judged against one cloud side by side, the leading one first.
import { headline, isOfFiles, product } from '../data/product';
import type { Report, Summary } from '../data/schema';
import type { State } from '../state';
import { button, h, table, type Column } from '../ui/dom';
import { interval, metres, percent } from '../ui/format';

/** The line files of an evaluation that has several, the leading one first; empty for other
 * reports. */
export function comparedFiles(report: Report): string[] {
  const [patch] = report.patches;
  if (!patch || !isOfFiles(report) || patch.methods.length < 2) return [];
  const leading = product(patch)!.name;
  return [leading, ...patch.methods.map((m) => m.name).filter((name) => name !== leading)];
}

/** A table with one row per file, for all its lines. A click on a name shows the file in the plan
 * and in all panels. */
export function lineFiles(state: State): HTMLElement | null {
  const { report } = state;
  const names = comparedFiles(report);
  if (names.length === 0) return null;
  const rows = names.flatMap((name) => report.table2.filter((r) => r.method === name && r.class === 'total'))
    .map((r): Summary & { method: string } => ({ ...headline(r), method: r.method }));
  const show = (name: string): void => state.chooseMethod(state.patch.methods.findIndex((m) => m.name === name));
  const columns: Column<(typeof rows)[number]>[] = [
    { title: 'line file', cell: (r) => button(r.method, () => show(r.method), { class: 'plain', title: 'show its lines' }) },
    { title: 'judged', number: true, cell: (r) => `${r.n_evaluated} of ${r.n_lines}` },
    { title: 'RMS', number: true, cell: (r) => metres(r.rms_m) },
    { title: '95 % interval', number: true, cell: (r) => interval(r.ci95_m) },
    { title: 'median', number: true, cell: (r) => metres(r.median_m) },
    { title: '95 %', number: true, cell: (r) => metres(r.q95_m) },
    { title: 'gross %', number: true, hint: 'lines with a distance above the gross limit', cell: (r) => percent(r.gross_share) },
  ];
  return h('div', { id: 'line-files' }, h('h3', {}, 'Line files side by side, m'), table(columns, rows),
    h('p', { class: 'caption' }, `The large figure refers to ${names[0]}, the first file. Plan and worst lines refer to the selected file.`));
}

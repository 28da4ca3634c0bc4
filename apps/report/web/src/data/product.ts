// SPDX-License-Identifier: BSD-3-Clause
// Which method's lines are the product; the others are baselines and never shown first.
import type { Line, Method, Patch, Report, Table2Row } from './schema';

const byRank = ['network', 'joint', 'direct'];

export const isOfFiles = (report: Report): boolean => report.run.command === 'evaluate';

/** The product is the best method that was run, or the first of several line files, whatever it is called. */
export function productIndex(report: Report, patch: Patch): number {
  if (isOfFiles(report)) return 0;
  for (const name of byRank) {
    const index = patch.methods.findIndex((m) => m.name === name);
    if (index >= 0) return index;
  }
  return 0;
}

export const product = (report: Report, patch: Patch): Method | undefined => patch.methods[productIndex(report, patch)];

/** The rows of class `total` of each patch's product. */
export function productRows(report: Report): Table2Row[] {
  return report.patches.flatMap((patch) => {
    const name = product(report, patch)?.name;
    return report.table2.filter((row) => row.patch === patch.id && row.method === name && row.class === 'total');
  });
}

/** Whether a further image should show the line and does not. */
export const isUnconfirmed = (line: Line): boolean => line.construction === 'unconfirmed' || line.status === 'unconfirmed';

/** The judged lines farthest off, each with its index. */
export function worstLines(lines: readonly Line[], n: number): { line: Line; index: number }[] {
  return lines.map((line, index) => ({ line, index })).filter(({ line }) => line.mean_distance_m !== null)
    .sort((a, b) => b.line.mean_distance_m! - a.line.mean_distance_m!).slice(0, n);
}

// SPDX-License-Identifier: BSD-3-Clause
// Which method's lines are the product; the others are baselines and never shown first.
import type { ClassSummary, Line, Method, Patch, Report, Summary, Table2Row } from './schema';
import { metres } from '../ui/format';

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

/** The figures of the lines on whose surface plan and images decided. */
export const headline = (of: ClassSummary): Summary => of.decided_by?.plan_images ?? of;

/** Those of the lines on which points or their place decided; null if there are none. */
export function ofPlace(of: ClassSummary): Summary | null {
  const figures = of.decided_by?.points_place;
  return figures && figures.n_evaluated > 0 ? figures : null;
}

/** The rows that a class has in a table, the headline first. */
export function rowsOf(name: string, of: ClassSummary): { name: string; figures: Summary }[] {
  const place = ofPlace(of);
  if (!place) return [{ name, figures: of }];
  return [{ name: `${name} plan_images`, figures: headline(of) }, { name: `${name} points_place`, figures: place }, { name: `${name} all`, figures: of }];
}

/** The lines beside the headline. */
export const placeSentence = (of: { n: number; rms_m: number | null }): string =>
  `points or the place decided on ${of.n} more ${of.n === 1 ? 'line' : 'lines'}, RMS ${metres(of.rms_m)} m`;

/** How few lines make a figure what it is. */
export const halfSentence = (of: Summary): string =>
  `${of.n_half_of_squares} of ${of.n_evaluated} lines make half of the sum of squares; RMS of the others ${metres(of.rms_without_half_m)} m`;

/** The judged lines of the headline that are farthest off, each with its index. */
export function worstLines(lines: readonly Line[], n: number): { line: Line; index: number }[] {
  const isOfHeadline = (line: Line): boolean => line.mean_distance_m !== null && line.decided_by !== 'points' && line.decided_by !== 'place';
  return lines.map((line, index) => ({ line, index })).filter(({ line }) => isOfHeadline(line))
    .sort((a, b) => b.line.mean_distance_m! - a.line.mean_distance_m!).slice(0, n);
}

// SPDX-License-Identifier: BSD-3-Clause
// The product of a run and its headline figures.
import type { ClassSummary, Line, Method, Patch, Report, Summary, Table2Row } from './schema';
import { metres } from '../ui/format';

export const isOfFiles = (report: Report): boolean => report.run.command === 'evaluate';

export const product = (patch: Patch): Method | undefined => patch.methods[patch.product];

/** The rows of class `total` of each patch's product. */
export function productRows(report: Report): Table2Row[] {
  return report.patches.flatMap((patch) => {
    const name = product(patch)?.name;
    return report.table2.filter((row) => row.patch === patch.id && row.method === name && row.class === 'total');
  });
}

/** Whether a further image should show the line but does not. */
export const isUnconfirmed = (line: Line): boolean => line.construction === 'unconfirmed' || line.status === 'unconfirmed';

/** The figures of the lines whose surface was decided by plan and images. */
export const headline = (of: ClassSummary): Summary => of.decided_by?.plan_images ?? of;

/** The figures of the lines decided by points or their own place; null if there are none. */
export function ofPlace(of: ClassSummary): Summary | null {
  const figures = of.decided_by?.points_place;
  return figures && figures.n_evaluated > 0 ? figures : null;
}

/** The rows of a class in a table, the headline first. */
export function rowsOf(name: string, of: ClassSummary): { name: string; figures: Summary }[] {
  const place = ofPlace(of);
  if (!place) return [{ name, figures: of }];
  return [{ name: `${name} plan_images`, figures: headline(of) }, { name: `${name} points_place`, figures: place }, { name: `${name} all`, figures: of }];
}

/** A sentence about the lines not in the headline. */
export const placeSentence = (of: { n: number; rms_m: number | null }): string =>
  `${of.n} more ${of.n === 1 ? 'line' : 'lines'} decided by points or position, RMS ${metres(of.rms_m)} m`;

/** States how few lines dominate a figure. */
export const halfSentence = (of: Summary): string =>
  `${of.n_half_of_squares} of ${of.n_evaluated} lines contribute half of the sum of squares; RMS of the others ${metres(of.rms_without_half_m)} m`;

/** The lines of the headline that are farthest off, each with its index. */
export function worstLines(lines: readonly Line[], n: number): { line: Line; index: number }[] {
  const isOfHeadline = (line: Line): boolean => line.mean_distance_m !== null && line.decided_by !== 'points' && line.decided_by !== 'place';
  return lines.map((line, index) => ({ line, index })).filter(({ line }) => isOfHeadline(line))
    .sort((a, b) => b.line.mean_distance_m! - a.line.mean_distance_m!).slice(0, n);
}

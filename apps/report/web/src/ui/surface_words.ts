// SPDX-License-Identifier: BSD-3-Clause
// Describes the surface that a line is assumed to bound.
import type { Line } from '../data/schema';
import { percent, words } from './format';

/** "lower, else object"; empty if the surface is unknown. */
export const surfaceWords = (line: Line): string =>
  [line.surface, line.surface_other].filter((name) => name).map((name) => words(name!)).join(', else ');

/** The same with the probability of the surface and the deciding evidence: "lower (97.0 %), else
 * object; decided by place". */
export function surfaceSentence(line: Line): string {
  if (!line.surface) return '';
  const share = typeof line.surface_probability === 'number' ? ` (${percent(line.surface_probability)} %)` : '';
  const other = line.surface_other ? `, else ${words(line.surface_other)}` : '';
  return `${words(line.surface)}${share}${other}${line.decided_by ? `; decided by ${line.decided_by}` : ''}`;
}

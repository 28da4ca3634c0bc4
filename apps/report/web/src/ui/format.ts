// SPDX-License-Identifier: BSD-3-Clause
// Numbers with the digits of table2.md: metres with three decimals, shares in percent with one.

type Maybe = number | null | undefined;

export const missing = '–';

export function fixed(value: Maybe, decimals: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return missing;
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace('-', '') : text.replace('-', '\u2212');
}

export const metres = (value: Maybe): string => fixed(value, 3);
export const percent = (share: Maybe): string => fixed(share === null || share === undefined ? null : 100 * share, 1);
export const interval = (range: readonly [number, number] | null): string =>
  range ? `${metres(range[0])} – ${metres(range[1])}` : missing;
export const words = (name: string): string => name.replaceAll('_', ' ');

export function excluded(counts: Record<string, number>): string {
  const parts = Object.entries(counts).map(([reason, n]) => `${words(reason)} ${n}`);
  return parts.length > 0 ? parts.join(', ') : missing;
}

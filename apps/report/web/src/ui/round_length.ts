// SPDX-License-Identifier: BSD-3-Clause

/** The largest of 1, 2, 5, 10, ... that does not exceed a length. */
export function roundLength(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  return [5, 2, 1].map((m) => m * power).find((v) => v <= length) ?? power;
}

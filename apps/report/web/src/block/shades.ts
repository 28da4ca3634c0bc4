// SPDX-License-Identifier: BSD-3-Clause
// The figures that a plan of patches can show, and the shade of each value. Limits are fixed, so
// that blocks can be compared. The shades (ColorBrewer's YlGnBu) become darker step by step, so
// that they can be distinguished by colour-blind readers and in print without colour.
import { fixed, metres, missing, percent } from '../ui/format';
import type { Figures } from './schema';

const shades = ['#ffffcc', '#c7e9b4', '#7fcdbb', '#41b6c4', '#1d91c0', '#225ea8', '#0c2c84'] as const;
const firstWithWhiteText = 4;

export interface Figure {
  key: string;
  name: string;
  unit: string;
  /** Limits of the shades, from pale to dark: decreasing for shares, increasing for all other
   * figures. */
  limits: readonly number[];
  falls?: boolean;
  /** The meaning of dark shades. */
  dark: string;
  value: (f: Figures) => number | null;
  text: (value: number | null) => string;
  /** The text inside a square. */
  short: (value: number) => string;
}

const share = (n: number, of: number): number | null => (of > 0 ? n / of : null);
const shares = { unit: '%', limits: [0.95, 0.9, 0.8, 0.7, 0.6, 0.4], falls: true, dark: 'Darker is worse.', text: percent, short: (v: number) => fixed(100 * v, 0) } as const;
const lengths = { unit: 'm', dark: 'Darker is worse.', text: metres, short: (v: number) => fixed(v, v < 0.0995 ? 3 : 2) } as const;

/** Limits for a count, at round numbers. */
function countLimits(most: number): number[] {
  const sixth = Math.max(most / 7, 1);
  const power = 10 ** Math.floor(Math.log10(sixth));
  const step = [1, 2, 5, 10].map((m) => m * power).find((v) => v >= sixth) ?? sixth;
  return [1, 2, 3, 4, 5, 6].map((k) => k * step);
}

/** The figures available in these rows. */
export function figuresOf(rows: readonly Figures[]): Figure[] {
  const most = rows.reduce((m, f) => Math.max(m, f.n_lines), 0);
  const all: Figure[] = [
    { key: 'rms', name: 'RMS distance', limits: [0.03, 0.06, 0.1, 0.15, 0.25, 0.5], ...lengths, value: (f) => f.rms_m },
    { key: 'median', name: 'median distance', limits: [0.01, 0.02, 0.03, 0.05, 0.1, 0.2], ...lengths, value: (f) => f.median_m },
    { key: 'judged', name: 'share of lines judged', ...shares, value: (f) => share(f.n_evaluated, f.n_lines) },
    { key: 'found', name: 'share of true lines found', ...shares, value: (f) => share(f.n_reference_found, f.n_reference_lines) },
    { key: 'lines', name: 'number of lines', unit: '', limits: countLimits(most), dark: 'Darker is more.', value: (f) => f.n_lines, text: (v) => (v === null ? missing : String(v)), short: String },
  ];
  return all.filter((figure) => rows.some((f) => figure.value(f) !== null));
}

export function shadeOf(figure: Figure, value: number): number {
  const beyond = figure.limits.filter((limit) => (figure.falls ? value < limit : value > limit));
  return beyond.length;
}

export const shadeColour = (shade: number): string => shades[shade]!;
export const shadeInk = (shade: number): string => (shade >= firstWithWhiteText ? '#ffffff' : '#16202c');

/** The range of a shade in words. */
export function shadeText(figure: Figure, shade: number): string {
  const { limits, text, unit, falls } = figure;
  const of = (i: number): string => text(limits[i]!).replace(/(\.\d*?)0+$/, '$1').replace(/\.$/, '');
  const last = limits.length;
  if (shade === 0) return `${falls ? 'at least' : 'up to'} ${of(0)} ${unit}`.trim();
  if (shade === last) return `${falls ? 'below' : 'above'} ${of(last - 1)} ${unit}`.trim();
  return `${falls ? `${of(shade)} – ${of(shade - 1)}` : `${of(shade - 1)} – ${of(shade)}`} ${unit}`.trim();
}

/** The state of a square without a value, which is marked by a pattern, never by colour alone. */
export type State = 'failed' | 'empty' | 'none';
export const stateText: Record<State, string> = { failed: 'failed', empty: 'no lines', none: 'no figure' };

export function stateOf(figure: Figure, figures: Figures, reason: string): State | null {
  if (reason !== '') return 'failed';
  if (figures.n_lines === 0) return 'empty';
  return figure.value(figures) === null ? 'none' : null;
}

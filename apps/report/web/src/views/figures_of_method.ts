// SPDX-License-Identifier: BSD-3-Clause
// Statistics of one method on one patch: classes, accuracy statement, strata, calibration.
import { rowsOf } from '../data/product';
import type { Accuracy, Calibration, Method, Patch, Stratum, Summary } from '../data/schema';
import { h, table, type Column } from '../ui/dom';
import { fixed, interval, metres, missing, percent, words } from '../ui/format';
import { summaryColumns } from './head';
import { standards } from './standards';

interface Named<T> { name: string; value: T }
const named = <T>(record: Record<string, T>): Named<T>[] => Object.entries(record).map(([name, value]) => ({ name, value }));

function classTable(method: Method): HTMLElement {
  const rows = named(method.summary).flatMap(({ name, value }) => rowsOf(name, value)).map(({ name, figures }) => ({ ...figures, class: name }));
  return table<Summary & { class: string }>(
    [{ title: 'class', cell: (r) => words(r.class) }, ...summaryColumns<Summary & { class: string }>()], rows, { id: 'statistics' });
}

function accuracyTable(method: Method): HTMLElement {
  const columns: Column<Named<Accuracy>>[] = [
    { title: 'class', cell: (r) => words(r.name) },
    { title: 'n', number: true, cell: (r) => String(r.value.n) },
    { title: 'observed', number: true, hint: 'RMS against the planes, as in Table 2', cell: (r) => metres(r.value.observed_m) },
    { title: 'product', number: true, hint: 'against the true datum: including the error of the reference', cell: (r) => metres(r.value.product_m) },
    { title: 'method only', number: true, hint: 'without the error of the reference', cell: (r) => r.value.n > 0 && r.value.method_only_m === null ? 'below reference noise' : metres(r.value.method_only_m) },
    { title: 'sigma of the reference', number: true, cell: (r) => metres(r.value.sigma_ref_m) },
    { title: 'flags', cell: (r) => r.value.flags.map(words).join(', ') || missing },
  ];
  return table(columns, named(method.accuracy), { id: 'accuracy' });
}

function calibrationText(c: Calibration): string {
  if (c.nees_per_dof === null || c.bounds95 === null) return 'No line has a covariance.';
  const verdict = c.nees_per_dof > c.bounds95[1] ? 'optimistic (sigmas too small)'
    : c.nees_per_dof < c.bounds95[0] ? 'pessimistic (sigmas too large)' : 'correct';
  const beyond = c.share_beyond_99_9 === null ? '' : `${percent(c.share_beyond_99_9)} % beyond 3.29 (0.1 % expected); `;
  return `On average, predicted sigmas are ${verdict}: mean normalised squared error ${fixed(c.nees_per_dof, 2)} per degree of freedom `
    + `(${fixed(c.bounds95[0], 2)} to ${fixed(c.bounds95[1], 2)} expected, n = ${c.n}); median z² ${fixed(c.median_z2, 3)} (0.455 expected); `
    + `${percent(c.coverage_1_96)} % of |z| up to 1.96 (95 % expected); ${beyond}median sigma ${metres(c.median_sigma_m)} m.`;
}

function strataTable(by: string, strata: readonly Stratum[]): HTMLElement {
  const columns: Column<Stratum>[] = [
    { title: words(by), cell: (s) => s.stratum },
    { title: 'n', number: true, cell: (s) => `${s.n_evaluated}/${s.n_lines}` },
    { title: 'RMS', number: true, cell: (s) => metres(s.rms_m) },
    { title: '95 % interval', number: true, cell: (s) => interval(s.ci95_m) },
    { title: 'NMAD', number: true, cell: (s) => metres(s.nmad_m) },
    { title: '95 %', number: true, cell: (s) => metres(s.q95_m) },
    { title: 'NEES/dof', number: true, cell: (s) => fixed(s.calibration.nees_per_dof, 2) },
  ];
  return table(columns, strata);
}

/** Compares two methods on the lines evaluated for both; their other figures refer to different
 * lines. */
function pairedText(method: Method, other: Method): string {
  const distances = new Map(other.lines.map((l) => [l.id, l.mean_distance_m]));
  const pairs = method.lines.flatMap((l) => {
    const d = distances.get(l.id);
    return l.mean_distance_m !== null && typeof d === 'number' ? [[l.mean_distance_m, d] as const] : [];
  });
  if (pairs.length === 0) return `No line was evaluated both by ${method.name} and by ${other.name}.`;
  const rms = (side: 0 | 1): number => Math.sqrt(pairs.reduce((sum, p) => sum + p[side] ** 2, 0) / pairs.length);
  const same_m = 0.001;
  const better = pairs.filter(([a, b]) => a < b - same_m).length;
  const worse = pairs.filter(([a, b]) => a > b + same_m).length;
  return `On the ${pairs.length} lines evaluated by both: ${method.name} ${metres(rms(0))} m, ${other.name} ${metres(rms(1))} m RMS; `
    + `${method.name} is closer for ${better} lines, farther for ${worse}, within 1 mm for ${pairs.length - better - worse}.`;
}

export function figuresOfMethod(method: Method, patch: Patch, note: string): HTMLElement[] {
  const total = method.summary['total'];
  return [
    h('h3', {}, `Statistics: ${method.name}`),
    classTable(method),
    ...patch.methods.filter((m) => m !== method).map((other) => h('p', { class: 'paired' }, pairedText(method, other))),
    h('h3', {}, 'Accuracy statement'),
    accuracyTable(method),
    h('p', { class: 'caption' }, 'Observed: against the fitted planes. Product: against the true datum, with the error of laser and planes added. Method only: with that error subtracted. NMAD: 1.4826 times the median absolute deviation, a robust standard deviation.'),
    h('p', { class: 'caption' }, note, ' ', total
      ? `In the style of ASPRS Edition 2: RMSE ${metres(method.accuracy['total']?.product_m)} m including the error of the reference, from ${total.n_evaluated} lines`
        + (total.n_evaluated < 30 ? ' (fewer than the 30 it requires).' : '.') : ''),
    ...standards(method),
    h('p', { id: 'calibration' }, calibrationText(method.calibration)),
    h('p', { class: 'caption' }, 'NEES: squared distance over the predicted variance of line and plane; 1 on average if the predictions are correct. A few lines judged against a wrong surface raise the mean considerably: those beyond 3.29. The median and the share within 1.96 describe the others.'),
    h('details', {}, h('summary', {}, 'Strata'), ...Object.entries(method.strata).map(([by, strata]) => strataTable(by, strata))),
  ];
}

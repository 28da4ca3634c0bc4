// SPDX-License-Identifier: BSD-3-Clause
// Gates and Tables 1 and 2.
import { headline, isOfFiles, ofPlace, rowsOf } from '../data/product';
import type { PatchTracks, Report, Summary, Table1Row, Table2Row, TrackCell } from '../data/schema';
import { h, table, type Column } from '../ui/dom';
import { excluded, fixed, interval, metres, missing, percent, words } from '../ui/format';

const unique = (names: readonly string[]): string[] => [...new Set(names)];

const hasFigures = (report: Report): boolean => report.table2.some((row) => row.rms_m !== null);

/** The sentences shown instead of missing figures. */
export const messages = (report: Report): HTMLElement[] =>
  (report.run.messages ?? []).map((text) => h('p', { class: 'message', role: 'status' }, text));

export function gateTable(report: Pick<Report, 'gates'>): HTMLElement | null {
  if (!report.gates) return null;
  const number = (value: number | null): string => fixed(value, 4);
  return h('section', { id: 'gates' }, h('h2', {}, 'Gates'),
    table([
      { title: 'gate', cell: (g) => g.rule },
      { title: 'patch', cell: (g) => g.patch },
      { title: 'method', cell: (g) => g.method },
      { title: 'value', number: true, cell: (g) => number(g.value) },
      { title: 'limit', number: true, cell: (g) => number(g.limit) },
      { title: 'baseline', number: true, cell: (g) => number(g.baseline) },
      { title: 'n', number: true, cell: (g) => String(g.n) },
      { title: 'verdict', cell: (g) => h('span', { class: `badge ${g.verdict}` }, g.verdict) },
      { title: 'why', cell: (g) => g.explanation ?? '' },
    ], report.gates.gates),
    ...report.gates.warnings.map((w) => h('p', { class: 'caption' }, `Warning: ${w}`)));
}

const kMaxImages = 5; // 5 means five or more

function trackTable(tracks: readonly PatchTracks[]): HTMLElement {
  const rows = tracks.flatMap(({ patch, cells }) =>
    cells.filter((c) => c.class === 'total' && c.edges > 0).map((cell) => ({ patch, cell })));
  const share = (title: string, of: (c: TrackCell) => number | null): Column<(typeof rows)[number]> =>
    ({ title, number: true, cell: (r) => percent(of(r.cell)) });
  const images = (n: number | null): string => n === null ? 'all' : `${n}${n === kMaxImages ? ' and more' : ''}`;
  return h('section', {}, h('h3', {}, 'Tracks, by true edges'),
    table([
      { title: 'patch', cell: (r) => r.patch },
      { title: 'images', cell: (r) => images(r.cell.n_images) },
      { title: 'edges', number: true, cell: (r) => String(r.cell.edges) },
      { title: 'found', number: true, cell: (r) => String(r.cell.edges_found) },
      share('edge recall %', (c) => c.edge_recall),
      share('observation recall %', (c) => c.observation_recall),
      share('observation precision %', (c) => c.observation_precision),
    ], rows, { id: 'table1-tracks' }),
    h('p', { class: 'caption' }, 'Images: number of images that show the edge. An edge is found if one track lies on it in two images. An edge without segments is missed.'));
}

function table1(report: Report): HTMLElement | null {
  if (isOfFiles(report)) return null;
  const rows = report.table1;
  const hasMatches = report.patches.some((p) => p.images?.pairs.some((pair) => pair.matches.length > 0));
  const withInterval = (share: number | null, ci: [number, number] | null): string =>
    ci ? `${percent(share)} (${percent(ci[0])} – ${percent(ci[1])})` : percent(share);
  const columns: Column<Table1Row>[] = [
    { title: 'patch', cell: (r) => r.patch },
    { title: 'matcher', cell: (r) => r.matcher },
    { title: 'correct', number: true, cell: (r) => String(r.correct) },
    { title: 'false', number: true, cell: (r) => String(r.false) },
    { title: 'missed', number: true, cell: (r) => String(r.missed) },
    { title: 'correctness %', number: true, cell: (r) => withInterval(r.correctness, r.correctness_ci95) },
    { title: 'completeness %', number: true, cell: (r) => withInterval(r.completeness, r.completeness_ci95) },
    { title: 'quality %', number: true, cell: (r) => withInterval(r.quality, r.quality_ci95) },
    { title: 'not judged', number: true, hint: 'matches of lines absent from the reference', cell: (r) => String(r.unjudged) },
  ];
  return h('section', {}, h('h2', {}, 'Table 1. Matching'),
    rows.length > 0 ? table(columns, rows, { id: 'table1' })
      : h('p', { class: 'caption', id: 'table1-missing' }, hasMatches ? 'No reference matches were given, so matches are not judged. You can judge them by eye in the review below.' : 'There are no matches: the lines come from elsewhere, or images and matches could not be read.'),
    rows.length > 0 ? h('p', { class: 'caption' }, 'In parentheses: 95 % Wilson intervals over the number of matches.') : null,
    report.table1_tracks ? trackTable(report.table1_tracks) : null);
}

/** The published form: one row per patch, methods side by side. */
export function table2(rows: readonly Table2Row[]): HTMLElement {
  const methods = unique(rows.map((r) => r.method));
  const order = ['not_aligned', 'aligned', 'total'];
  const classes = unique(rows.map((r) => r.class)).sort((a, b) => order.indexOf(a) - order.indexOf(b));
  const cell = (patch: string, method: string, c: string): HTMLElement => {
    const s = rows.find((r) => r.patch === patch && r.method === method && r.class === c);
    if (!s) return h('td', { class: 'number' }, missing);
    const [first, place] = [headline(s), ofPlace(s)];
    return h('td', { class: 'number' }, metres(first.rms_m), h('small', {}, ` ${first.n_evaluated}/${s.n_lines}`,
      place ? ` + ${metres(place.rms_m)} ${place.n_evaluated}/${s.n_lines}` : null));
  };
  return h('div', { class: 'scroll' }, h('table', { id: 'table2' },
    h('thead', {},
      h('tr', {}, h('th', { rowspan: 2, scope: 'col' }, 'patch'),
        ...methods.map((m) => h('th', { colspan: classes.length, scope: 'colgroup', class: 'group' }, m))),
      h('tr', {}, ...methods.flatMap(() => classes.map((c) => h('th', { scope: 'col', class: 'number' }, words(c)))))),
    h('tbody', {}, ...unique(rows.map((r) => r.patch)).map((patch) =>
      h('tr', {}, h('th', { scope: 'row' }, patch),
        ...methods.flatMap((m) => classes.map((c) => cell(patch, m, c))))))));
}

/** Explains the small print in table2(). */
export const smallPrint = (rows: readonly Table2Row[]): string => `Small: lines evaluated / all lines. ${rows.some(ofPlace)
  ? 'First figure: lines whose surface was chosen by plan and images; after the +: lines decided by points or the line\u2019s own position. ' : ''}`;

/** All figures of a cell, as in table2.md. */
export function summaryColumns<Row extends Summary>(): Column<Row>[] {
  const metre = (title: string, value: (s: Row) => number | null | undefined, hint?: string): Column<Row> =>
    ({ title, number: true, cell: (s) => metres(value(s)), ...(hint ? { hint } : {}) });
  return [
    { title: 'n', number: true, hint: 'lines evaluated', cell: (s) => String(s.n_evaluated) },
    { title: 'lines', number: true, cell: (s) => String(s.n_lines) },
    { title: 'evaluated %', number: true, cell: (s) => percent(s.evaluated_share) },
    metre('RMS', (s) => s.rms_m),
    { title: '95 % interval', number: true, hint: 'clustered bootstrap', cell: (s) => interval(s.ci95_m) + (s.ci95_m && s.few_clusters ? ' (few clusters)' : '') },
    metre('bias', (s) => s.mean_m, 'mean of the signed distances'),
    metre('std', (s) => s.std_m),
    metre('median', (s) => s.median_m),
    metre('NMAD', (s) => s.nmad_m, 'of the signed distances'),
    metre('68.3 %', (s) => s.q683_m),
    metre('95 %', (s) => s.q95_m),
    metre('max', (s) => s.max_m),
    { title: 'half', number: true, hint: 'number of the worst lines that contribute half of the sum of squares', cell: (s) => fixed(s.n_half_of_squares, 0) },
    metre('without', (s) => s.rms_without_half_m, 'RMS of the other lines'),
    metre('RMSE H', (s) => s.rmse_horizontal_m, 'ridges and hips, across in plan'),
    metre('RMSE V', (s) => s.rmse_vertical_m, 'ridges and hips, in height'),
    { title: 'gross %', number: true, hint: 'lines with a distance above the gross limit', cell: (s) => percent(s.gross_share) },
    { title: 'excluded', cell: (s) => excluded(s.n_excluded) },
  ];
}

/** All figures of all rows, initially collapsed. */
export function table2Details(rows: readonly Table2Row[]): HTMLElement {
  type Row = Summary & Pick<Table2Row, 'patch' | 'method' | 'class'>;
  const all: Column<Row>[] = [
    { title: 'patch', cell: (r) => r.patch },
    { title: 'method', cell: (r) => r.method },
    { title: 'class', cell: (r) => words(r.class) },
    ...summaryColumns<Row>(),
  ];
  const allRows = rows.flatMap((row) => rowsOf(row.class, row).map(({ name, figures }): Row => ({ ...figures, patch: row.patch, method: row.method, class: name })));
  return h('details', {}, h('summary', {}, 'All figures'),
    table(all, allRows, { id: 'table2-all' }),
    h('p', { class: 'caption' }, 'Metres. Bias, std and NMAD refer to signed distances; median, quantiles and maximum to mean absolute distances. The distance to a single plane cannot show a shift within that plane.'));
}

export function head(report: Report): HTMLElement[] {
  return [
    gateTable(report),
    table1(report),
    !hasFigures(report) ? null : h('section', {}, h('h2', {}, 'Table 2. RMS of the average orthogonal distances from LIDAR planes, m'),
      table2(report.table2),
      report.table2_footnote === null ? null : h('p', { class: 'caption', id: 'table2-footnote' }, report.table2_footnote),
      h('p', { class: 'caption' }, smallPrint(report.table2), report.note),
      table2Details(report.table2)),
  ].filter((e): e is HTMLElement => e !== null);
}

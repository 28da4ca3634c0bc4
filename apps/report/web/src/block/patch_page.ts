// SPDX-License-Identifier: BSD-3-Clause
// The page of one patch: its lines in plan and in a table, and the data used.
import { distanceSteps, okabeIto, selectionColour } from '../data/colours';
import { append, h, replace, tabs } from '../ui/dom';
import { fixed, metres, percent, words } from '../ui/format';
import { SortedTable, type SortedColumn } from '../ui/sorted_table';
import { svg } from '../ui/svg';
import { themeButton } from '../ui/theme';
import { smallPrint, table2, table2Details } from '../views/head';
import { lineLegend } from './legend';
import { Sheet } from './map';
import type { Box, LineRow, PatchReport } from './schema';

const idOf = (l: LineRow): string => l[0];
const distanceOf = (l: LineRow): number | null => l[5];

function colourOf(line: LineRow): string {
  const d = distanceOf(line);
  return d === null ? okabeIto.grey : (distanceSteps.find((step) => d <= step.upTo_m)?.colour ?? okabeIto.grey);
}

const columns: readonly SortedColumn<LineRow>[] = [
  { key: 'id', title: 'line', value: idOf },
  { key: 'mean', title: 'distance m', number: true, hint: 'average orthogonal distance from the planes', value: distanceOf, cell: (l) => metres(distanceOf(l)) },
  { key: 'max', title: 'max m', number: true, value: (l) => l[6], cell: (l) => metres(l[6]) },
  { key: 'length', title: 'length m', number: true, value: (l) => l[4], cell: (l) => fixed(l[4], 2) },
  { key: 'class', title: 'class', value: (l) => l[1], cell: (l) => words(l[1]) },
  { key: 'kind', title: 'kind', value: (l) => l[2], cell: (l) => words(l[2]) },
  { key: 'status', title: 'status', value: (l) => l[3], cell: (l) => words(l[3]) },
  { key: 'images', title: 'images', number: true, value: (l) => l[7] },
  { key: 'height', title: 'height m', number: true, hint: 'of its middle', value: (l) => (l[10] + l[13]) / 2, cell: (l) => fixed((l[10] + l[13]) / 2, 2) },
];

export class PatchPage {
  private method = 0;
  private readonly content = h('div');
  private sheet: Sheet | null = null;

  constructor(private readonly report: PatchReport, root: HTMLElement) {
    const methods = tabs('Method', report.methods.map((m) => m.name), () => this.method, (m) => { this.method = m; methods.update(); this.show(); });
    replace(root, h('header', {}, h('h1', {}, `Patch ${report.id}`), h('div', { class: 'controls' }, themeButton(() => this.sheet?.drawRelief(report.points)))),
      h('nav', { class: 'controls', id: 'ways', 'aria-label': 'Pages' }, h('a', { href: '../report.html', id: 'back' }, `← Block ${report.block}`),
        ...Object.entries(report.neighbours).map(([side, id]) => h('a', { href: `${id}.html` }, `${side}: ${id}`))),
      report.reason === '' ? null : h('p', { class: 'message', id: 'reason' }, h('strong', {}, 'This patch has no lines. '), report.reason),
      report.methods.length > 1 ? methods.element : null, this.content);
    this.show();
  }

  /** The square, extended to lines that reach beyond it, within the area that was searched. */
  private box(lines: readonly LineRow[]): Box {
    const { core, area } = this.report;
    const margin = 3;
    const xs = lines.flatMap((l) => [l[8], l[11]]);
    const ys = lines.flatMap((l) => [l[9], l[12]]);
    return [Math.max(area[0], Math.min(core[0], ...xs) - margin), Math.max(area[1], Math.min(core[1], ...ys) - margin),
      Math.min(area[2], Math.max(core[2], ...xs) + margin), Math.min(area[3], Math.max(core[3], ...ys) + margin)];
  }

  private show(): void {
    const { report } = this;
    const { lines } = report.methods[this.method]!;
    const pointed = h('p', { class: 'caption', id: 'pointed', role: 'status' });
    const drawn = new Map<LineRow, SVGElement>();
    const table = new SortedTable(columns, lines, { id: 'line-table', sortBy: 'mean', descending: true, limit: 50, onPoint: (l) => point(l, false) });
    const point = (line: LineRow | null, isFromPlan: boolean): void => {
      for (const [l, element] of drawn) element.setAttribute('stroke', l === line ? selectionColour : colourOf(l));
      if (isFromPlan) table.mark(line);
      pointed.textContent = line === null ? 'Point at a line for details.' : `Line ${idOf(line)}: ${distanceOf(line) === null ? words(line[3] || 'not judged') : `${metres(distanceOf(line))} m`}, ${words(line[1])}${line[2] ? `, ${words(line[2])}` : ''}, ${fixed(line[4], 2)} m long.`;
    };
    this.sheet = new Sheet(this.box(lines), `Lines of patch ${report.id} in plan`, 860, 820);
    this.drawPlan(this.sheet, lines, drawn, point);
    point(null, true);
    replace(this.content, h('div', { class: 'map' },
      h('figure', { id: 'patch-plan' }, this.sheet.element, this.sheet.foot(), lineLegend(null), pointed),
      h('div', { class: 'beside' }, this.facts(), this.fullReport())),
    report.table2.length === 0 ? null : h('section', {}, h('h2', {}, 'Distances from LIDAR planes by class: RMS, m'), table2(report.table2), table2Details(report.table2),
      h('p', { class: 'caption' }, smallPrint(report.table2), report.note)),
    h('section', {}, h('h2', {}, `Lines (${lines.length})`), table.element));
    point(lines.find((l) => idOf(l) === decodeURIComponent(location.hash.slice(1))) ?? null, true);
  }

  private drawPlan(sheet: Sheet, lines: readonly LineRow[], drawn: Map<LineRow, SVGElement>, point: (line: LineRow | null, isFromPlan: boolean) => void): void {
    const { report } = this;
    sheet.drawRelief(report.points);
    const [left, top] = sheet.at(report.core[0], report.core[3]);
    const [right, bottom] = sheet.at(report.core[2], report.core[1]);
    sheet.drawing.append(svg('rect', { x: left, y: top, width: right - left, height: bottom - top, class: 'core' }));
    // the worst are drawn last, on top of the others
    for (const line of [...lines].sort((a, b) => (distanceOf(a) ?? -1) - (distanceOf(b) ?? -1))) {
      const isJudged = distanceOf(line) !== null;
      const [a, b] = [sheet.at(line[8], line[9]), sheet.at(line[11], line[12])];
      const ends = { x1: a[0], y1: a[1], x2: b[0], y2: b[1] };
      const stroke = svg('line', { ...ends, stroke: colourOf(line), 'stroke-width': isJudged ? 3 : 1.8, ...(isJudged ? {} : { 'stroke-dasharray': '5 4' }) });
      const group = svg('g', { class: 'line', 'data-line': idOf(line) },
        svg('title', {}, `${report.id}/${idOf(line)}: ${isJudged ? `${metres(distanceOf(line))} m` : words(line[3] || 'not judged')}`),
        svg('line', { ...ends, class: 'seam' }), stroke, svg('line', { ...ends, class: 'catch' }));
      for (const type of ['pointerenter', 'click']) group.addEventListener(type, () => point(line, true));
      drawn.set(line, stroke);
      sheet.drawing.append(group);
    }
  }

  private facts(): HTMLElement {
    const { report } = this;
    const { figures } = report.methods[this.method]!;
    const of = (n: number, all: number): string => `${n} of ${all}${all > 0 ? ` (${percent(n / all)} %)` : ''}`;
    const rows: [string, Node | string | null][] = [
      ['RMS distance', figures.rms_m === null ? null : `${metres(figures.rms_m)} m`],
      ['median, max', figures.rms_m === null ? null : `${metres(figures.median_m)} m, ${metres(figures.max_m)} m`],
      ['lines judged', of(figures.n_evaluated, figures.n_lines)],
      ['true lines found', figures.n_reference_lines > 0 ? of(figures.n_reference_found, figures.n_reference_lines) : null],
      ['images', report.images.join(', ')],
      ['heights searched', `${fixed(report.height_range_m[0], 1)} – ${fixed(report.height_range_m[1], 1)} m`],
      ['corner', `${report.origin_m[0]}, ${report.origin_m[1]} m (${report.crs})`],
      ['estimated', `${fixed(report.estimated_s, 0)} s of CPU time, ${fixed(report.estimated_mib, 0)} MiB`],
      ['LIDAR', report.points ? `${report.points.n_shown.toLocaleString('en')} points shown, grey from ${report.points.low_m} to ${report.points.high_m} m` : 'not shown'],
    ];
    return h('dl', { id: 'facts' }, ...rows.flatMap(([name, value]) => (value ? [h('dt', {}, name), h('dd', {}, value)] : [])));
  }

  private fullReport(): HTMLElement {
    const { id } = this.report;
    const note = h('div', { id: 'full-report' }, h('h3', {}, 'With images'));
    append(note, h('p', {}, 'Log, run time and memory: ', h('code', {}, `tasks/${id}/run.json`), ' next to the report of the block. For a report with images, segments and matches, reconstruct this patch again, without judging its lines, in the folder of the block:'),
      h('p', {}, h('code', {}, `ridgeline run tasks/${id}/patch.yaml --out FOLDER`)));
    return note;
  }
}

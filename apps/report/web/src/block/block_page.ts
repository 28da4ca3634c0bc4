// SPDX-License-Identifier: BSD-3-Clause
// The report of a block: its description, its figures, its plan, and its worst patches and lines.
import { halfSentence, headline, ofPlace, placeSentence } from '../data/product';
import { h, replace, tabs } from '../ui/dom';
import { fixed, interval, metres, percent, words } from '../ui/format';
import { SortedTable, type SortedColumn } from '../ui/sorted_table';
import { themeButton } from '../ui/theme';
import { gateTable, smallPrint, table2, table2Details } from '../views/head';
import { provenance } from '../views/provenance';
import { verdict } from '../views/verdict';
import { BlockPlan } from './plan';
import type { BlockReport, Figures, PatchRow, WorstLine } from './schema';

const linkTo = (patch: string, text = patch): HTMLElement => h('a', { href: `pages/${patch}.html` }, text);
const count = (n: number): string => n.toLocaleString('en');
const countOf = (n: number, what: string): string => `${count(n)} ${what}${n === 1 ? '' : 'es'}`;

export class BlockPage {
  private readonly plan: BlockPlan;
  private readonly tables = h('div', { class: 'tables' });
  private readonly summary = h('div');
  private method = 0;

  constructor(private readonly report: BlockReport, root: HTMLElement) {
    this.plan = new BlockPlan(report, this.method);
    const methods = tabs('Method', report.methods.map((m) => m.name), () => this.method, (m) => { this.method = m; methods.update(); this.show(); });
    replace(root, h('header', {}, h('h1', {}, report.run.page?.title || `Block ${report.name}: line reconstruction report`), h('div', { class: 'controls' }, themeButton(() => this.plan.draw()))),
      verdict(report), this.failures(), ...report.notes.map((note) => h('p', { class: 'message note' }, note)),
      report.methods.length > 1 ? methods.element : null,
      h('div', { class: 'columns' }, this.summary, this.facts()), this.plan.element, this.tables, gateTable(report), this.table2(), provenance(report));
    this.show();
  }

  private get done(): PatchRow[] {
    return this.report.patches.filter((p) => p.reason === '');
  }

  private failures(): HTMLElement | null {
    const n = this.report.patches.length - this.done.length;
    return n === 0 ? null : h('p', { class: 'message', id: 'failures' }, h('strong', {}, `${n} of ${countOf(this.report.patches.length, 'patch')} failed`), '. ', h('a', { href: '#failed' }, 'The reasons'), ' are listed below.');
  }

  private show(): void {
    this.plan.show(this.method);
    replace(this.summary, this.keyFigure(), this.whereItIsBad());
    replace(this.tables, this.worstPatches(), this.worstLines(), this.failed());
  }

  private keyFigure(): HTMLElement | null {
    const name = this.report.methods[this.method]?.name;
    const total = this.report.table2.find((r) => r.method === name && r.class === 'total');
    const row = total ? headline(total) : null;
    if (!total || !row || row.rms_m === null) return null;
    const place = ofPlace(total);
    const sum = (of: (f: Figures) => number): number => this.done.reduce((s, p) => s + of(p.figures[this.method]!), 0);
    const [found, all] = [sum((f) => f.n_reference_found), sum((f) => f.n_reference_lines)];
    const about = [row.ci95_m ? `95 % interval ${interval(row.ci95_m)} m` : null, `median ${metres(row.median_m)} m`,
      `${count(row.n_evaluated)} of ${count(row.n_lines)} lines judged (${percent(row.evaluated_share)} %)`, row.rms_without_half_m === undefined ? null : halfSentence(row),
      place ? placeSentence({ n: place.n_evaluated, rms_m: place.rms_m }) : null,
      all > 0 ? `${count(found)} of ${count(all)} true lines found (${percent(found / all)} %)` : null];
    return h('div', { id: 'key-figure' }, h('span', { class: 'value' }, `${metres(row.rms_m)} m`),
      h('div', {}, h('strong', {}, 'RMS distance of the lines from LIDAR planes'), h('p', { class: 'caption' }, `${about.filter((t) => t !== null).join('; ')}.`)));
  }

  /** One sentence that names the worst patches. */
  private whereItIsBad(): HTMLElement | null {
    const judged = this.done.filter((p) => p.figures[this.method]!.rms_m !== null).sort((a, b) => b.figures[this.method]!.rms_m! - a.figures[this.method]!.rms_m!);
    if (judged.length === 0) return null;
    const worst = judged.slice(0, 3).flatMap((p, i) => [i > 0 ? ', ' : '', linkTo(p.id), ` (${metres(p.figures[this.method]!.rms_m)} m)`]);
    const limit_m = 0.15;
    const above = judged.filter((p) => p.figures[this.method]!.rms_m! > limit_m).length;
    return h('p', { id: 'worst-sentence' }, 'Worst by RMS: ', ...worst, `. ${above === 0 ? 'No patch is' : above === 1 ? '1 patch is' : `${count(above)} patches are`} above ${limit_m} m.`);
  }

  private facts(): HTMLElement {
    const { report } = this;
    const files = (role: string): string => (report.run.inputs ?? []).filter((i) => i.role === role).map((i) => i.path).join(', ');
    const images = (report.run.inputs ?? []).filter((i) => i.role === 'image').length;
    const n = report.patches.length;
    const withoutViews = report.n_without_views > 0 ? `; ${report.n_without_views} more squares are visible in fewer than two images` : '';
    const rows: [string, string | undefined][] = [
      ['Project', report.run.page?.project], ['Operator', report.run.page?.operator], ['Date', report.run.page?.date],
      ['Product', `3D lines by method ${report.methods[0]?.name ?? ''} from ${images} images`],
      ['Patches', `${countOf(n, 'patch')} of ${report.patch_size_m} m with ${report.overlap_m} m of overlap; ${count(this.done.length)} done, ${count(n - this.done.length)} failed${withoutViews}`],
      ['Reference', files('cloud') || 'none'], ['True lines', files('reference')],
      ['CRS', report.crs], ['Corner', `${report.origin_m[0]}, ${report.origin_m[1]} m (south-west)`],
      ['Made with', `ridgeline ${report.run.versions?.['ridgeline'] ?? ''}`],
    ];
    return h('dl', { id: 'facts' }, ...rows.flatMap(([name, value]) => (value ? [h('dt', {}, name), h('dd', {}, value)] : [])));
  }

  private worstPatches(): HTMLElement {
    const of = (p: PatchRow): Figures => p.figures[this.method]!;
    const rows = this.done;
    const share = (n: number, all: number): number | null => (all > 0 ? n / all : null);
    const metre = (key: 'rms_m' | 'median_m' | 'max_m', title: string): SortedColumn<PatchRow> => ({ key, title, number: true, value: (p) => of(p)[key], cell: (p) => metres(of(p)[key]) });
    const columns: SortedColumn<PatchRow>[] = [
      { key: 'id', title: 'patch', value: (p) => p.id, cell: (p) => linkTo(p.id) },
      metre('rms_m', 'RMS m'), metre('median_m', 'median m'), metre('max_m', 'max m'),
      { key: 'n_lines', title: 'lines', number: true, value: (p) => of(p).n_lines },
      { key: 'judged', title: 'judged %', number: true, value: (p) => share(of(p).n_evaluated, of(p).n_lines), cell: (p) => percent(share(of(p).n_evaluated, of(p).n_lines)) },
    ];
    if (rows.some((p) => of(p).n_reference_lines > 0)) {
      columns.push({ key: 'found', title: 'true lines found %', number: true, value: (p) => share(of(p).n_reference_found, of(p).n_reference_lines), cell: (p) => percent(share(of(p).n_reference_found, of(p).n_reference_lines)) });
    }
    columns.push({ key: 'images', title: 'images', number: true, value: (p) => p.n_images });
    return h('section', {}, h('h2', {}, 'Worst patches'), new SortedTable(columns, rows, { id: 'patch-table', sortBy: 'rms_m', descending: true, limit: 15 }).element);
  }

  private worstLines(): HTMLElement | null {
    const rows = this.report.methods[this.method]?.worst ?? [];
    if (rows.length === 0) return null;
    const columns: SortedColumn<WorstLine>[] = [
      { key: 'id', title: 'line', value: (l) => `${l.patch}/${l.id}`, cell: (l) => h('a', { href: `pages/${l.patch}.html#${encodeURIComponent(l.id)}` }, `${l.patch}/${l.id}`) },
      { key: 'mean', title: 'distance m', number: true, hint: 'average orthogonal distance from the planes', value: (l) => l.mean_m, cell: (l) => metres(l.mean_m) },
      { key: 'max', title: 'max m', number: true, value: (l) => l.max_m, cell: (l) => metres(l.max_m) },
      { key: 'length', title: 'length m', number: true, value: (l) => l.length_m, cell: (l) => fixed(l.length_m, 2) },
      { key: 'class', title: 'class', value: (l) => l.class, cell: (l) => words(l.class) },
      { key: 'kind', title: 'kind', value: (l) => l.kind, cell: (l) => words(l.kind) },
      { key: 'status', title: 'status', value: (l) => l.status, cell: (l) => words(l.status) },
      { key: 'images', title: 'images', number: true, value: (l) => l.n_images },
    ];
    return h('section', {}, h('h2', {}, 'Worst lines'), new SortedTable(columns, rows, { id: 'worst-lines', sortBy: 'mean', descending: true, limit: 20 }).element);
  }

  private failed(): HTMLElement | null {
    const rows = this.report.patches.filter((p) => p.reason !== '');
    if (rows.length === 0) return null;
    return h('section', { id: 'failed' }, h('h2', {}, 'Patches that failed'),
      new SortedTable<PatchRow>([
        { key: 'id', title: 'patch', value: (p) => p.id, cell: (p) => linkTo(p.id) },
        { key: 'images', title: 'images', number: true, value: (p) => p.n_images },
        { key: 'reason', title: 'reason', value: (p) => p.reason },
      ], rows, { id: 'failed-table', sortBy: 'id', limit: 50 }).element);
  }

  private table2(): HTMLElement | null {
    const { report } = this;
    if (report.table2.length === 0) return null;
    return h('section', {}, h('h2', {}, 'Table 2. RMS of the average orthogonal distances from LIDAR planes, m'), table2(report.table2),
      report.table2_footnote === null ? null : h('p', { class: 'caption', id: 'table2-footnote' }, report.table2_footnote),
      h('p', { class: 'caption', id: 'fixed-sentence' }, smallPrint(report.table2), report.note), table2Details(report.table2));
  }
}

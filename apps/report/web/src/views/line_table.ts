// SPDX-License-Identifier: BSD-3-Clause
// All lines of a method: sorted, filtered, selected, exported.
import { headline, worstLines } from '../data/product';
import type { Line } from '../data/schema';
import type { State } from '../state';
import { append, button, choice, h, replace } from '../ui/dom';
import { csv, download } from '../ui/download';
import { fixed, metres, missing, words } from '../ui/format';

interface LineColumn {
  key: string;
  title: string;
  hint?: string;
  value: (line: Line) => string | number | null | undefined;
  text?: (line: Line) => string;
}

const metreColumn = (key: string, title: string, value: (l: Line) => number | null | undefined, hint?: string): LineColumn =>
  ({ key, title, value, text: (l) => metres(value(l)), ...(hint ? { hint } : {}) });

const columns: readonly LineColumn[] = [
  { key: 'id', title: 'line', value: (l) => l.id },
  { key: 'class', title: 'class', value: (l) => l.class, text: (l) => words(l.class) },
  { key: 'status', title: 'status', value: (l) => l.status, text: (l) => words(l.status) },
  { key: 'kind', title: 'kind', value: (l) => l.kind, text: (l) => l.kind ?? '' },
  { key: 'surface', title: 'surface', hint: 'surface that the line is assumed to bound', value: (l) => l.surface },
  { key: 'surface_other', title: 'else', hint: 'second most probable surface', value: (l) => l.surface_other },
  { key: 'decided_by', title: 'decided by', hint: 'evidence that decided on the surface', value: (l) => l.decided_by },
  { key: 'epipolar_angle_deg', title: 'angle °', hint: 'to the epipolar line', value: (l) => l.epipolar_angle_deg, text: (l) => fixed(l.epipolar_angle_deg, 1) },
  { key: 'length_m', title: 'length m', value: (l) => l.length_m, text: (l) => fixed(l.length_m, 2) },
  metreColumn('mean_distance_m', 'distance m', (l) => l.mean_distance_m, 'average orthogonal distance from the planes'),
  metreColumn('max_distance_m', 'max m', (l) => l.max_distance_m),
  metreColumn('signed_mean_m', 'signed m', (l) => l.signed_mean_m),
  metreColumn('sigma_line_m', 'sigma m', (l) => l.sigma_line_m, 'predicted, along the plane normal'),
  { key: 'z', title: 'z', hint: 'signed distance divided by sigma', value: (l) => l.z, text: (l) => fixed(l.z, 2) },
  metreColumn('true_error_m', 'true error m', (l) => l.true_error_m, 'distance from the true line'),
  { key: 'n_points', title: 'points', hint: 'artificial points used', value: (l) => l.n_points, text: (l) => (l.n_points === undefined ? '' : String(l.n_points)) },
  { key: 'n_images', title: 'images', hint: 'images that show it', value: (l) => l.n_images },
  { key: 'flags', title: 'flags', value: (l) => l.flags.join(' '), text: (l) => l.flags.map(words).join(', ') },
];

const isNumeric = (c: LineColumn, lines: readonly Line[]): boolean => lines.some((l) => typeof c.value(l) === 'number');

/** Compares two lines by a column. Missing values come last in either direction; ids are in natural
 * order (2 before 10). */
function compare(a: Line, b: Line, column: LineColumn, descending: boolean): number {
  const x = column.value(a);
  const y = column.value(b);
  const lacks = (v: unknown): boolean => v === null || v === undefined;
  if (lacks(x) || lacks(y)) return Number(lacks(x)) - Number(lacks(y));
  const order = typeof x === 'number' && typeof y === 'number' ? x - y
    : String(x).localeCompare(String(y), 'en', { numeric: true });
  return descending ? -order : order;
}

/** Only with more than two images: both images of a pair show every line. */
const showsNumberOfImages = (lines: readonly Line[]): boolean => lines.some((l) => (l.n_images ?? 0) > 2);

const kPage = 500;

export class LineTable {
  readonly element = h('section', { id: 'lines' });
  private readonly body = h('tbody');
  private readonly headRow = h('tr');
  private readonly count = h('span', { class: 'caption', id: 'line-count', role: 'status' });
  private readonly more = button('Show all rows', () => { this.limit = Infinity; this.render(); });
  private readonly filters = h('div', { class: 'controls' });
  private sortKey = 'mean_distance_m';
  private descending = true;
  private half = new Set<number>();
  private text = '';
  private lineClass = '';
  private status = '';
  private nImages = '';
  private limit = kPage;
  private shown: number[] = [];

  constructor(private readonly state: State) {
    append(this.element, h('h3', {}, 'Lines'), this.filters,
      h('div', { class: 'scroll tall' }, h('table', { id: 'line-table', 'aria-label': 'Lines' }, h('thead', {}, this.headRow), this.body)), this.more);
    this.body.addEventListener('keydown', (event) => this.onKey(event));
    this.body.addEventListener('click', (event) => {
      const row = (event.target as Element).closest('tr');
      if (row) this.choose(Number(row.dataset['line']));
    });
    state.onChange((now, before) => {
      if (now.patch !== before.patch || now.method !== before.method) this.rebuild();
      else if (now.line !== before.line) this.reveal();
    });
    this.rebuild();
  }

  private rebuild(): void {
    const lines = this.state.method.lines;
    const values = (get: (l: Line) => string): { value: string; text: string }[] =>
      [{ value: '', text: 'all' }, ...[...new Set(lines.map(get))].sort().map((v) => ({ value: v, text: words(v) }))];
    if (!lines.some((l) => l.class === this.lineClass)) this.lineClass = '';
    if (!lines.some((l) => l.status === this.status)) this.status = '';
    if (!showsNumberOfImages(lines) || !lines.some((l) => String(l.n_images ?? missing) === this.nImages)) this.nImages = '';
    const search = h('input', { type: 'search', value: this.text, placeholder: 'id, kind, flag …', 'aria-label': 'Filter lines', id: 'line-filter',
      oninput: () => { this.text = search.value; this.render(); } });
    replace(this.filters, h('label', { class: 'field' }, h('span', {}, 'Filter'), search),
      choice('class', values((l) => l.class), this.lineClass, (v) => { this.lineClass = v; this.render(); }),
      choice('status', values((l) => l.status), this.status, (v) => { this.status = v; this.render(); }),
      showsNumberOfImages(lines) ? choice('images', values((l) => String(l.n_images ?? missing)), this.nImages, (v) => { this.nImages = v; this.render(); }) : null,
      button('Export CSV', () => this.exportCsv(), { id: 'export-lines' }), this.count);
    const total = this.state.method.summary['total'];
    this.half = new Set(worstLines(lines, total ? headline(total).n_half_of_squares ?? 0 : 0).map(({ index }) => index));
    this.limit = kPage;
    this.renderHead();
    this.render();
  }

  private renderHead(): void {
    replace(this.headRow, ...this.columns().map((c) => {
      const isSorted = c.key === this.sortKey;
      return h('th', { scope: 'col', title: c.hint, class: isNumeric(c, this.state.method.lines) ? 'number' : undefined,
        'aria-sort': isSorted ? (this.descending ? 'descending' : 'ascending') : 'none' },
      button(c.title + (isSorted ? (this.descending ? ' ▾' : ' ▴') : ''), () => this.sortBy(c.key), { class: 'plain', 'data-key': c.key }));
    }));
  }

  /** The columns that have values. */
  private columns(): readonly LineColumn[] {
    const lines = this.state.method.lines;
    return columns.filter((c) => c.key === 'n_images' ? showsNumberOfImages(lines) : c.key === 'id' || lines.some((l) => { const v = c.value(l); return v !== null && v !== undefined && v !== ''; }));
  }

  private sortBy(key: string): void {
    this.descending = key === this.sortKey ? !this.descending : false;
    this.sortKey = key;
    this.renderHead();
    this.headRow.querySelector<HTMLElement>(`[data-key="${key}"]`)?.focus();
    this.render();
  }

  private filtered(): number[] {
    const lines = this.state.method.lines;
    const text = this.text.trim().toLowerCase();
    const matches = (l: Line): boolean => (this.lineClass === '' || l.class === this.lineClass)
      && (this.status === '' || l.status === this.status)
      && (this.nImages === '' || String(l.n_images ?? missing) === this.nImages)
      && (text === '' || [l.id, l.class, l.status, l.kind ?? '', l.construction ?? '', ...l.flags].some((v) => v.toLowerCase().includes(text)));
    const column = columns.find((c) => c.key === this.sortKey) ?? columns[0]!;
    return lines.map((_, i) => i).filter((i) => matches(lines[i]!))
      .sort((a, b) => compare(lines[a]!, lines[b]!, column, this.descending) || a - b);
  }

  private render(): void {
    const lines = this.state.method.lines;
    const shownColumns = this.columns();
    const all = this.filtered();
    this.shown = all.slice(0, this.limit);
    const numeric = shownColumns.map((c) => isNumeric(c, lines));
    replace(this.body, ...this.shown.map((i) => {
      const line = lines[i]!;
      return h('tr', { 'data-line': i, tabindex: -1, title: line.reason, class: this.half.has(i) ? 'half' : undefined },
        ...shownColumns.map((c, k) => h('td', { class: numeric[k] ? 'number' : undefined }, c.text ? c.text(line) : String(c.value(line) ?? ''))));
    }));
    this.more.hidden = all.length <= this.shown.length;
    this.count.textContent = `${all.length} of ${lines.length} lines; bold: those that contribute half of the sum of squares` + (all.length > this.shown.length ? `, the first ${this.shown.length} shown` : '');
    this.mark(false);
  }

  private rowOf(line: number | null): HTMLElement | null {
    return line === null ? null : this.body.querySelector<HTMLElement>(`tr[data-line="${line}"]`);
  }

  /** Shows all rows if the selected line is not among those shown. */
  private reveal(): void {
    const { line } = this.state.now;
    if (line !== null && !this.rowOf(line) && this.filtered().includes(line)) {
      this.limit = Infinity;
      this.render();
    }
    this.mark(true);
  }

  private mark(scroll: boolean): void {
    for (const row of this.body.querySelectorAll('tr[aria-selected]')) row.removeAttribute('aria-selected');
    const row = this.rowOf(this.state.now.line);
    row?.setAttribute('aria-selected', 'true');
    for (const other of this.body.querySelectorAll<HTMLElement>('tr[tabindex="0"]')) other.tabIndex = -1;
    const entry = row ?? this.body.querySelector<HTMLElement>('tr');
    if (entry) entry.tabIndex = 0;
    if (row && scroll) this.scrollTo(row);
  }

  /** Scrolls to a row within the table only, without scrolling the page. */
  private scrollTo(row: HTMLElement): void {
    const box = this.body.closest('.scroll');
    if (!box) return;
    const top = row.offsetTop - box.clientHeight / 2;
    if (row.offsetTop < box.scrollTop + 30 || row.offsetTop > box.scrollTop + box.clientHeight - 30) box.scrollTop = top;
  }

  private choose(line: number): void {
    this.state.set({ line });
    this.rowOf(line)?.focus({ preventScroll: true });
  }

  private onKey(event: KeyboardEvent): void {
    const row = (event.target as Element).closest('tr');
    if (!row) return;
    const at = this.shown.indexOf(Number(row.dataset['line']));
    const steps: Record<string, number> = { ArrowDown: 1, ArrowUp: -1, PageDown: 20, PageUp: -20, Home: -Infinity, End: Infinity };
    const step = steps[event.key];
    if (step !== undefined) {
      const line = this.shown[Math.min(this.shown.length - 1, Math.max(0, at + step))];
      if (line !== undefined) this.choose(line);
      event.preventDefault();
    } else if (event.key === 'Enter' || event.key === ' ') {
      this.choose(Number(row.dataset['line']));
      event.preventDefault();
    }
  }

  private exportCsv(): void {
    const lines = this.state.method.lines;
    const rows = this.filtered().map((i) => columns.map((c) => c.value(lines[i]!)));
    download(`lines.${this.state.patch.id}.${this.state.method.name}.csv`, csv([columns.map((c) => c.key), ...rows]));
  }
}

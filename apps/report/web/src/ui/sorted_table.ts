// SPDX-License-Identifier: BSD-3-Clause
// A table that can be sorted by its columns and shows only its first rows until all are requested.
import { button, h, replace } from './dom';

type Value = string | number | null;

export interface SortedColumn<Row> {
  key: string;
  title: string;
  hint?: string;
  number?: boolean;
  value: (row: Row) => Value;
  cell?: (row: Row) => string | Node;
}

export interface SortedOptions<Row> {
  id: string;
  sortBy: string;
  descending?: boolean;
  limit?: number;
  onPoint?: (row: Row | null) => void; // the row under the pointer or with the focus
}

export class SortedTable<Row> {
  readonly element: HTMLElement;
  private readonly headRow = h('tr');
  private readonly body = h('tbody');
  private readonly count = h('span', { class: 'caption', role: 'status' });
  private readonly more = button('Show all rows', () => { this.limit = Infinity; this.render(); });
  private sortKey: string;
  private descending: boolean;
  private limit: number;
  private shownRows: Row[] = [];

  constructor(private readonly columns: readonly SortedColumn<Row>[], private rows: readonly Row[], private readonly options: SortedOptions<Row>) {
    this.sortKey = options.sortBy;
    this.descending = options.descending ?? false;
    this.limit = options.limit ?? Infinity;
    this.element = h('div', { class: 'sorted' },
      h('div', { class: 'scroll' }, h('table', { id: options.id }, h('thead', {}, this.headRow), this.body)),
      h('p', { class: 'controls' }, this.count, this.more));
    this.renderHead();
    this.render();
  }

  show(rows: readonly Row[]): void {
    this.rows = rows;
    this.render();
  }

  private renderHead(): void {
    replace(this.headRow, ...this.columns.map((c) => {
      const isSorted = c.key === this.sortKey;
      return h('th', { scope: 'col', title: c.hint, class: c.number ? 'number' : undefined,
        'aria-sort': isSorted ? (this.descending ? 'descending' : 'ascending') : 'none' },
      button(c.title + (isSorted ? (this.descending ? ' ▾' : ' ▴') : ''), () => this.sortBy(c), { class: 'plain', 'data-key': c.key }));
    }));
  }

  /** Numbers start with the largest, words in alphabetical order. */
  private sortBy(column: SortedColumn<Row>): void {
    this.descending = column.key === this.sortKey ? !this.descending : column.number ?? false;
    this.sortKey = column.key;
    this.renderHead();
    this.headRow.querySelector<HTMLElement>(`[data-key="${column.key}"]`)?.focus();
    this.render();
  }

  /** Missing values come last in either direction; ids are in natural order (2 before 10). */
  private compare(a: Row, b: Row): number {
    const column = this.columns.find((c) => c.key === this.sortKey)!;
    const [x, y] = [column.value(a), column.value(b)];
    if (x === null || y === null) return Number(x === null) - Number(y === null);
    const order = typeof x === 'number' && typeof y === 'number' ? x - y : String(x).localeCompare(String(y), 'en', { numeric: true });
    return this.descending ? -order : order;
  }

  private render(): void {
    this.shownRows = [...this.rows].sort((a, b) => this.compare(a, b)).slice(0, this.limit);
    replace(this.body, ...this.shownRows.map((row) => {
      const element = h('tr', {}, ...this.columns.map((c) => h('td', { class: c.number ? 'number' : undefined }, c.cell ? c.cell(row) : String(c.value(row) ?? ''))));
      this.listen(element, row);
      return element;
    }));
    const isCut = this.rows.length > this.shownRows.length;
    this.more.hidden = !isCut;
    this.count.textContent = isCut ? `the first ${this.shownRows.length} of ${this.rows.length}` : '';
  }

  private listen(element: HTMLElement, row: Row): void {
    const { onPoint } = this.options;
    if (!onPoint) return;
    for (const type of ['pointerenter', 'focusin', 'click']) element.addEventListener(type, () => onPoint(row));
    for (const type of ['pointerleave', 'focusout']) element.addEventListener(type, () => onPoint(null));
  }

  /** Marks the row whose item is pointed at outside the table. */
  mark(row: Row | null): void {
    [...this.body.rows].forEach((element, i) => element.classList.toggle('marked', row !== null && this.shownRows[i] === row));
  }
}

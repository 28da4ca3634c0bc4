// SPDX-License-Identifier: BSD-3-Clause
// All elements are made here. Text becomes text nodes, so that data is never interpreted as markup.

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | EventListener | null | undefined>;

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
  }
  append(element, ...children);
  return element;
}

export function append(parent: Element, ...children: Child[]): void {
  for (const child of children) if (child) parent.append(child);
}

export function replace(parent: Element, ...children: Child[]): void {
  parent.replaceChildren();
  append(parent, ...children);
}

export interface Column<Row> {
  title: string;
  hint?: string;
  number?: boolean;
  cell: (row: Row) => string | Node;
}

/** A plain table; numbers are right-aligned. */
export function table<Row>(columns: readonly Column<Row>[], rows: readonly Row[], attributes: Attributes = {}): HTMLElement {
  const of = (c: Column<Row>): Attributes => ({ class: c.number ? 'number' : undefined });
  return h('div', { class: 'scroll' },
    h('table', attributes,
      h('thead', {}, h('tr', {}, ...columns.map((c) => h('th', { ...of(c), scope: 'col', title: c.hint }, c.title)))),
      h('tbody', {}, ...rows.map((row) => h('tr', {}, ...columns.map((c) => h('td', of(c), c.cell(row))))))));
}

export function button(text: string, onclick: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return h('button', { type: 'button', onclick, ...attributes }, text);
}

/** A menu from which one option is chosen. */
export function choice<T extends string>(
  label: string,
  options: readonly { value: T; text: string }[],
  chosen: T,
  onchange: (value: T) => void,
): HTMLElement {
  const select = h('select', { onchange: () => onchange(select.value as T), 'aria-label': label });
  for (const option of options) {
    append(select, h('option', { value: option.value, selected: option.value === chosen }, option.text));
  }
  return h('label', { class: 'field' }, h('span', {}, label), select);
}

export function checkbox(label: string, checked: boolean, onchange: (on: boolean) => void, attributes: Attributes = {}): HTMLElement {
  const input = h('input', { type: 'checkbox', checked, onchange: () => onchange(input.checked) });
  return h('label', { class: 'field', ...attributes }, input, h('span', {}, label));
}

/** A row of buttons, one of which is pressed. */
export function tabs(label: string, names: readonly string[], chosen: () => number, onchoose: (index: number) => void): { element: HTMLElement; update: () => void } {
  const buttons = names.map((name, i) => button(name, () => onchoose(i), { class: 'tab' }));
  const update = (): void => buttons.forEach((b, i) => b.setAttribute('aria-pressed', String(i === chosen())));
  update();
  return { element: h('div', { class: 'tabs', role: 'group', 'aria-label': label }, h('span', {}, label), ...buttons), update };
}

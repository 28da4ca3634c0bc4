// SPDX-License-Identifier: BSD-3-Clause
import { button, h } from '../ui/dom';

const keys: readonly [string, string][] = [
  ['Tab, arrow keys', 'in the line table: next and previous line'],
  ['1, 2, …', 'method'],
  ['t', '3D view from above'],
  ['Escape', 'clear the selection; leave the review'],
  ['r', 'start or leave the review of the matches'],
  ['n, p', 'review: next and previous match'],
  ['c, f, u', 'review: correct, false, unsure; moves on to the next unjudged match'],
  ['m', 'review: add a missed match by clicking its segment in each image'],
  ['?', 'this help'],
];

export function helpDialog(): HTMLDialogElement {
  const dialog = h('dialog', { id: 'help', 'aria-label': 'Help' },
    h('h2', {}, 'Keys and mouse'),
    h('table', {}, h('tbody', {}, ...keys.map(([key, text]) => h('tr', {}, h('th', { scope: 'row' }, h('kbd', {}, key)), h('td', {}, text))))),
    h('p', {}, '3D view: drag to orbit, right drag to move, wheel to zoom, click a line to select it. Images: drag to move, wheel to zoom, double click to fit, click a segment to select its line.'));
  dialog.append(button('Close', () => dialog.close()));
  return dialog;
}

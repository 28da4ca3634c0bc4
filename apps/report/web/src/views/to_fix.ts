// SPDX-License-Identifier: BSD-3-Clause
// What to fix first: wrong lines and buildings, ordered by the gain from correcting them.
import type { Method, ToFix } from '../data/schema';
import type { State } from '../state';
import { button, h, table } from '../ui/dom';
import { metres, missing, percent, words } from '../ui/format';

const shownRows = 10;

function move(entry: ToFix): string {
  const { move_x_m: x, move_y_m: y, move_z_m: z } = entry;
  const parts = [
    x !== null && y !== null ? `x ${metres(x)}, y ${metres(y)}` : null,
    z !== null ? `z ${metres(z)}` : null,
  ].filter((text) => text !== null);
  return parts.length > 0 ? parts.join(', ') : missing;
}

/** Empty if there is nothing to fix. */
export function toFix(state: State, method: Method): HTMLElement[] {
  const list = method.to_fix ?? [];
  if (list.length === 0) return [];
  const lineOf = (entry: ToFix): number => method.lines.findIndex((l) => (entry.what === 'line' ? l.id === entry.id : l.building === entry.id));
  const name = (entry: ToFix): Node | string => {
    const line = lineOf(entry);
    return line < 0 ? entry.id : button(entry.id, () => state.set({ line }), { class: 'plain', title: 'select it' });
  };
  return [
    h('h3', {}, 'What to fix first'),
    table<ToFix>([
      { title: 'what', cell: (e) => e.what },
      { title: 'id', cell: name },
      { title: 'kind', cell: (e) => words(e.kind) },
      { title: 'gain, %', number: true, cell: (e) => percent(e.gain_share), hint: 'share of the sum of squares of all lines, or of the points above all roofs' },
      { title: 'off, m', number: true, cell: (e) => metres(e.off_m), hint: 'mean distance of a line, or RMS height difference of the points above a roof' },
      { title: 'move by, m', cell: move, hint: 'correction to add to the coordinates; a line with one plane only gives the height' },
    ], list.slice(0, shownRows), { id: 'to-fix-table' }),
    h('p', { class: 'caption' }, `${list.length > shownRows ? `The first ${shownRows} of ${list.length}; ` : ''}${list.length > shownRows ? 'all' : 'also'} in to_fix.csv and in the layer to_fix of the map.`),
  ];
}

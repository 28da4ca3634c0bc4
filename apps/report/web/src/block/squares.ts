// SPDX-License-Identifier: BSD-3-Clause
// The squares of the patches, each a link to the page of its patch. Shades show a figure, patterns
// mark squares without one; the arrow keys move from square to square.
import { replace } from '../ui/dom';
import { svg } from '../ui/svg';
import type { Sheet } from './map';
import type { PatchRow } from './schema';
import { shadeColour, shadeInk, shadeOf, stateOf, type Figure } from './shades';

const leastForText = 40; // units of the drawing

/** The patterns of squares without a value, for a drawing. */
export function patterns(): SVGElement {
  const pattern = (id: string, size: number, d: string): SVGElement =>
    svg('pattern', { id: `pattern-${id}`, width: size, height: size, patternUnits: 'userSpaceOnUse' },
      svg('rect', { width: size, height: size, class: 'pattern-paper' }), svg('path', { d, class: `pattern-${id}` }));
  return svg('defs', {}, pattern('failed', 8, 'M -2 2 L 2 -2 M 0 8 L 8 0 M 6 10 L 10 6'), pattern('none', 8, 'M 3.2 4 h 1.6'));
}

export class Squares {
  private readonly links: SVGElement[] = [];
  private readonly bySquare = new Map<string, number>();
  private current = 0;

  constructor(private readonly sheet: Sheet, private readonly patches: readonly PatchRow[], private readonly onPoint: (patch: number | null) => void) {
    patches.forEach((p, i) => this.bySquare.set(p.square.join(), i));
    sheet.drawing.addEventListener('keydown', (event) => this.onKey(event as KeyboardEvent));
    sheet.drawing.addEventListener('pointerleave', () => onPoint(null));
  }

  /** `asFrames`: only the rims are shaded, so that the points and lines in the squares remain
   * visible. */
  show(figure: Figure, method: number, asFrames: boolean): void {
    this.links.length = 0;
    replace(this.sheet.drawing, patterns(), ...this.patches.map((patch, i) => this.square(patch, i, figure, method, asFrames)));
  }

  private square(patch: PatchRow, i: number, figure: Figure, method: number, asFrames: boolean): SVGElement {
    const figures = patch.figures[method]!;
    const state = stateOf(figure, figures, patch.reason);
    const value = figure.value(figures);
    const shade = value === null ? 0 : shadeOf(figure, value);
    const [left, top] = this.sheet.at(patch.core[0], patch.core[3]);
    const [right, bottom] = this.sheet.at(patch.core[2], patch.core[1]);
    const [width, height] = [right - left, bottom - top];
    const rim = asFrames && !state ? Math.max(2, 0.04 * Math.min(width, height)) : 0;
    const told = state ? { failed: `failed: ${patch.reason}`, empty: 'no lines', none: `no ${figure.name}` }[state] : `${figure.name} ${figure.text(value)} ${figure.unit}`;
    const link = svg('a', { href: `pages/${patch.id}.html`, tabindex: i === this.current ? 0 : -1, class: state ?? 'shade', 'data-patch': patch.id, 'aria-label': `Patch ${patch.id}, ${told}` },
      svg('rect', { x: left + rim / 2, y: top + rim / 2, width: Math.max(width - rim, 1), height: Math.max(height - rim, 1),
        ...(state ? {} : { fill: rim ? 'none' : shadeColour(shade), ...(rim ? { stroke: shadeColour(shade), 'stroke-width': rim } : {}) }) }));
    if (rim) link.append(svg('rect', { x: left, y: top, width, height, class: 'rim' }));
    const text = state === 'failed' ? '×' : state === 'empty' ? '–' : !state && !rim && value !== null && Math.min(width, height) >= leastForText ? figure.short(value) : '';
    if (text !== '') {
      link.append(svg('text', { x: (left + right) / 2, y: (top + bottom) / 2, 'text-anchor': 'middle', 'dominant-baseline': 'central', class: state ? 'mark' : Math.min(width, height) >= 110 ? 'value wide' : 'value',
        'font-size': Math.min(state ? 28 : 15, 0.5 * Math.min(width, height)), ...(state ? {} : { fill: shadeInk(shade) }) }, text));
    }
    for (const type of ['pointerenter', 'focus']) link.addEventListener(type, () => this.onPoint(i));
    link.addEventListener('click', (event) => this.onClick(event as PointerEvent, i));
    this.links[i] = link;
    return link;
  }

  /** A touch screen has no pointer: the first tap shows the figures, the second opens the page. */
  private onClick(event: PointerEvent, i: number): void {
    if (event.pointerType === 'touch' && this.tapped !== i) event.preventDefault();
    this.tapped = i;
    this.onPoint(i);
  }
  private tapped: number | null = null;

  private onKey(event: KeyboardEvent): void {
    const steps: Record<string, [number, number]> = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const step = steps[event.key];
    const at = this.links.indexOf(document.activeElement as unknown as SVGElement);
    if (!step || at < 0) return;
    event.preventDefault();
    const next = this.nextOf(this.patches[at]!.square, step);
    if (next === undefined) return;
    this.links[this.current]!.setAttribute('tabindex', '-1');
    this.current = next;
    this.links[next]!.setAttribute('tabindex', '0');
    this.links[next]!.focus();
  }

  /** The next square in a direction; squares in between may be missing. */
  private nextOf([column, row]: readonly [number, number], step: readonly [number, number]): number | undefined {
    const most = this.patches.reduce((m, p) => Math.max(m, Math.abs(p.square[0] - column), Math.abs(p.square[1] - row)), 0);
    for (let k = 1; k <= most; ++k) {
      const found = this.bySquare.get([column + k * step[0], row + k * step[1]].join());
      if (found !== undefined) return found;
    }
    return undefined;
  }
}

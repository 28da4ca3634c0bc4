// SPDX-License-Identifier: BSD-3-Clause
// The pair of images, and further ones on request, with segments (Fig. 1), matches (Fig. 7) or
// reconstructed lines, and the selected line with its epipolar lines.
import { classColour, okabeIto, selectionColour, verdictColours } from '../data/colours';
import { distanceToSegment, type Point2 } from '../data/geometry';
import type { ImageSegment, Line, PairOfViews } from '../data/schema';
import type { Review } from '../review/review';
import type { State } from '../state';
import { append, button, choice, h, replace } from '../ui/dom';
import { ImageCanvas, type Stroke } from './image_canvas';
import { viewWords } from './line_in_view';
import { sideOf, type PatchImages } from './patch_images';

type Layer = 'matches' | 'segments' | 'lines' | 'none';

const strokeOf: Record<string, Stroke> = {
  correct: { colour: verdictColours.correct, width: 2 },
  false: { colour: verdictColours.false, width: 2, dash: [7, 4] },
  missed: { colour: verdictColours.missed, width: 2.5, dash: [2, 3] },
  unsure: { colour: verdictColours.unsure, width: 2, dash: [10, 3, 2, 3] },
  unjudged: { colour: verdictColours.unjudged, width: 1.2 },
};

function legendItem(text: string, stroke: Stroke): HTMLElement {
  const canvas = h('canvas', { width: 28, height: 10, 'aria-hidden': 'true' });
  const g = canvas.getContext('2d')!;
  g.strokeStyle = stroke.colour;
  g.lineWidth = Math.max(2, stroke.width);
  g.setLineDash(stroke.dash ?? []);
  g.beginPath();
  g.moveTo(0, 5);
  g.lineTo(28, 5);
  g.stroke();
  return h('span', { class: 'legend-item' }, canvas, text);
}

/** An image on the page. */
interface ShownImage {
  canvas: ImageCanvas;
  figure: HTMLElement;
  /** Describes how the selected line appears in it. */
  words: HTMLElement;
}

export class ImagePair {
  readonly element = h('section', { id: 'images' });
  private readonly controls = h('div', { class: 'controls' });
  private readonly choices = h('div', { class: 'controls', id: 'image-choice' });
  private readonly box = h('div', { class: 'pair' });
  private readonly legend = h('p', { class: 'legend' });
  private shown: ShownImage[] = []; // by image
  private images: PatchImages | null = null;
  private layer: Layer = 'matches';
  /** Whether the first two images of the selected line are shown: true until the reader chooses a
   * pair. */
  private followsLine = true;
  private isClicked = false; // a line selected in an image leaves the images as they are
  private further = new Set<number>(); // images in addition to the pair

  constructor(private readonly state: State, private readonly review: Review) {
    append(this.element, h('h3', {}, 'Images'), this.controls, this.choices, this.box, this.legend);
    state.onChange((now, before) => {
      if (now.line !== before.line || now.method !== before.method) this.followLine();
      if (now.pair !== before.pair && now.patch === before.patch) this.showPair();
      if (now.match !== before.match) this.frameMatch();
      if (now.match !== null && before.match === null) this.element.scrollIntoView({ block: 'start' });
      if (now.patch === before.patch) this.draw();
    });
    review.onChange(() => { this.updateLegend(); this.draw(); });
  }

  show(images: PatchImages | null): void {
    this.images = images;
    this.shown = [];
    this.further.clear();
    this.followsLine = true;
    if (!images) {
      replace(this.controls);
      replace(this.choices);
      replace(this.legend);
      replace(this.box, h('p', { class: 'caption' }, this.state.patch.notes.length > 0 ? 'The images of this patch are not in the report; see the notes above.' : 'This run had no images.'));
      return;
    }
    this.shown = images.images.views.map((view, v) => {
      const canvas = new ImageCanvas(images.pictures[v]!, [view.width_px, view.height_px], `Image ${view.id}`, (c) => this.paint(v, c), (x, reach) => this.click(v, x, reach));
      const words = h('span', { class: 'view-words' });
      return { canvas, words, figure: h('figure', { id: `image-${v}` }, canvas.canvas, h('figcaption', { class: 'caption' }, `${view.id} (${view.file})`, words)) };
    });
    replace(this.controls,
      choice<Layer>('show', [{ value: 'matches', text: 'matches (Fig. 7)' }, { value: 'segments', text: 'segments (Fig. 1)' }, { value: 'lines', text: '3D lines, projected' }, { value: 'none', text: 'nothing' }],
        this.layer, (layer) => { this.layer = layer; this.updateLegend(); this.draw(); }),
      button('Fit', () => this.shown.forEach((s) => s.canvas.fit())));
    this.showPair();
  }

  draw(): void {
    const { images } = this;
    if (!images) return;
    for (const v of this.shownViews()) {
      const { canvas, words } = this.shown[v]!;
      canvas.draw();
      if (images.areSeveral) replace(words, ...this.wordsOf(v));
    }
  }

  private wordsOf(v: number): (Node | string)[] {
    const { line } = this.state;
    const words = line ? viewWords(this.state.patch, line, v) : null;
    return words ? [': ', h('strong', { class: words.disagrees ? 'disagrees' : undefined }, words.word), words.more ? `, ${words.more}` : ''] : [];
  }

  get shownImages(): PatchImages | null {
    return this.images;
  }

  private get pair(): PairOfViews | null {
    return this.images?.pairs[this.state.now.pair] ?? null;
  }

  private shownViews(): number[] {
    const { pair } = this;
    if (!pair) return [];
    return [pair.base, pair.search, ...[...this.further].filter((v) => v !== pair.base && v !== pair.search).sort((a, b) => a - b)];
  }

  /** Shows the first two images of the selected line, unless the reader has chosen others or is
   * judging matches. */
  private followLine(): void {
    const { images, state } = this;
    const { line, now } = state;
    if (!images?.areSeveral || !line || !this.followsLine || this.isClicked || now.match !== null) return;
    const [first, second] = images.viewsOfLine(line);
    if (first !== undefined && second !== undefined) state.set({ pair: images.pairOf(first, second) });
  }

  private showPair(): void {
    replace(this.box, ...this.shownViews().map((v) => this.shown[v]!.figure));
    this.showChoices();
    this.updateLegend();
    this.draw();
  }

  /** The controls for choosing images; none if there are only two. */
  private showChoices(): void {
    const { images, pair } = this;
    if (!images?.areSeveral || !pair) {
      replace(this.choices);
      return;
    }
    const chosen = this.followsLine ? 'line' : String(this.state.now.pair);
    const pairs = images.pairs.map((p, i) => ({ value: String(i), text: `${images.nameOfPair(p)}, ${p.matches.length} matches` }));
    const others = images.images.views.map((view, v) => ({ view, v })).filter(({ v }) => v !== pair.base && v !== pair.search);
    replace(this.choices,
      choice('pair', [{ value: 'line', text: 'first two images of the selected line' }, ...pairs], chosen, (value) => this.choosePair(value)),
      h('span', { class: 'tabs', role: 'group', 'aria-label': 'further images' }, h('span', {}, 'and'),
        ...others.map(({ view, v }) => button(view.id, () => this.toggle(v), { 'aria-pressed': String(this.further.has(v)), class: 'tab' }))));
  }

  private choosePair(value: string): void {
    this.followsLine = value === 'line';
    if (this.followsLine) this.followLine();
    else this.state.set({ pair: Number(value), match: null });
    this.showChoices();
  }

  private toggle(view: number): void {
    if (!this.further.delete(view)) this.further.add(view);
    this.showPair();
  }

  private updateLegend(): void {
    const { images, pair } = this;
    if (!images || !pair) return;
    const items: HTMLElement[] = [];
    if (this.layer === 'segments') {
      items.push(legendItem(`aligned with the epipolar line (up to ${images.images.max_aligned_angle_deg}°)`, { colour: okabeIto.vermillion, width: 3 }), legendItem('not aligned', { colour: okabeIto.skyBlue, width: 1.5 }));
    } else if (this.layer === 'matches') {
      const counts = new Map<string, number>();
      for (const m of pair.matches) {
        const verdict = this.review.verdictOf(m);
        counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
      }
      const missed = this.review.missed().length;
      if (missed > 0) counts.set('missed', missed);
      for (const [verdict, stroke] of Object.entries(strokeOf)) {
        const n = counts.get(verdict);
        if (n) items.push(legendItem(`${verdict === 'unjudged' ? 'not judged' : verdict} ${n}`, stroke));
      }
    } else if (this.layer === 'lines') {
      items.push(legendItem('aligned', { colour: classColour('aligned'), width: 2, dash: [7, 4] }), legendItem('not aligned', { colour: okabeIto.skyBlue, width: 2 }));
    }
    replace(this.legend, ...items, legendItem('selected', { colour: selectionColour, width: 3 }), legendItem('its epipolar lines', { colour: okabeIto.purple, width: 1.5, dash: [4, 4] }));
  }

  private paint(v: number, canvas: ImageCanvas): void {
    const { images, pair } = this;
    if (!images || !pair) return;
    if (this.layer === 'segments' || this.layer === 'matches') this.paintSegments(v, canvas, images, v === pair.base ? pair.search : pair.base);
    if (this.layer === 'matches') this.paintMatches(v, canvas, images, pair);
    if (this.layer === 'lines') this.paintLines(v, canvas, images);
    this.paintSelected(v, canvas, images, pair);
  }

  private paintSegments(v: number, canvas: ImageCanvas, images: PatchImages, other: number): void {
    for (let i = 0; i < images.countOf(v); ++i) {
      const segment = images.segment(v, i)!;
      if (this.layer === 'matches') canvas.segment(segment, { colour: '#b4b4b490', width: 1 });
      else canvas.segment(segment, images.isAligned(v, other, i) ? { colour: okabeIto.vermillion, width: 2.5 } : { colour: okabeIto.skyBlue, width: 1.2 });
    }
  }

  private paintMatches(v: number, canvas: ImageCanvas, images: PatchImages, pair: PairOfViews): void {
    const side = sideOf(pair, v);
    if (side === null) return;
    for (const m of pair.matches) {
      const segment = images.segment(v, side === 0 ? m.left : m.right);
      if (segment) canvas.segment(segment, strokeOf[this.review.verdictOf(m)]!);
    }
    for (const missed of this.review.missed()) {
      const segment = images.segment(v, missed[side]);
      if (segment) canvas.segment(segment, strokeOf['missed']!);
    }
  }

  private paintLines(v: number, canvas: ImageCanvas, images: PatchImages): void {
    for (const line of this.state.method.lines) {
      const seen = images.projectedCurve(v, line);
      if (seen) canvas.curve(seen, line.class === 'aligned' ? { colour: okabeIto.vermillion, width: 1.6, dash: [7, 4] } : { colour: okabeIto.skyBlue, width: 1.6 });
    }
  }

  private paintSelected(v: number, canvas: ImageCanvas, images: PatchImages, pair: PairOfViews): void {
    const { line } = this.state;
    const match = this.review.current();
    const pending = this.review.pending(v);
    if (pending !== null) {
      const segment = images.segment(v, pending);
      if (segment) canvas.segment(segment, { colour: okabeIto.yellow, width: 4, halo: true });
    }
    if (match) {
      const side = sideOf(pair, v);
      const other = side === 0 ? pair.search : pair.base;
      const partner = images.segment(other, side === 0 ? match.right : match.left);
      if (partner) paintEpipolar(v, canvas, images, { view: other, segment: partner });
      const own = side === null ? null : images.segment(v, side === 0 ? match.left : match.right);
      if (own) canvas.segment(own, { colour: selectionColour, width: 3, halo: true });
      if (side !== null) return;
    }
    if (line) paintLine(v, canvas, images, line, 3, true, match === null);
  }

  private click(v: number, x: Point2, reach_px: number): void {
    const { images } = this;
    if (!images) return;
    let nearest: number | null = null;
    let distance = reach_px;
    for (let i = 0; i < images.countOf(v); ++i) {
      const d = distanceToSegment(x, images.segment(v, i)!);
      if (d < distance) [nearest, distance] = [i, d];
    }
    if (this.review.takesClick(v, nearest)) return;
    this.isClicked = true;
    this.state.set({ line: nearest === null ? this.lineAt(v, x, reach_px) : this.state.lineOfSegment(v, nearest) });
    this.isClicked = false;
  }

  /** The line at a position in an image. The report has no segments for lines of other tools, but
   * their files may give some. */
  private lineAt(v: number, x: Point2, reach_px: number): number | null {
    const { images } = this;
    if (!images) return null;
    let best: number | null = null;
    let distance = reach_px;
    this.state.method.lines.forEach((line, i) => {
      const stated = images.segmentsOfLine(v, line);
      const seen = images.projected(v, line);
      for (const segment of stated.length > 0 || !seen ? stated : [seen]) {
        const d = distanceToSegment(x, segment);
        if (d < distance) [best, distance] = [i, d];
      }
    });
    return best;
  }

  private frameMatch(): void {
    const match = this.review.current();
    const { images, pair } = this;
    if (!match || !images || !pair) return;
    for (const v of this.shownViews()) {
      const side = sideOf(pair, v);
      const { line } = this.state;
      const segment = side === null ? (line ? images.projected(v, line) : null) : images.segment(v, side === 0 ? match.left : match.right);
      if (segment) this.shown[v]!.canvas.frame(segment);
    }
  }
}

/** Draws a line: its projection, its segments and, if `epipolar` is set, the epipolar lines of its
 * first segment in another image. */
export function paintLine(v: number, canvas: ImageCanvas, images: PatchImages, line: Line, width: number, halo: boolean, epipolar = true): void {
  if (epipolar) paintEpipolar(v, canvas, images, images.partnerOf(v, line));
  const seen = images.projectedCurve(v, line);
  if (seen) canvas.curve(seen, { colour: okabeIto.black, width: 1.5, dash: [3, 3], halo: true });
  for (const own of images.segmentsOfLine(v, line)) canvas.segment(own, { colour: selectionColour, width, halo });
}

/** Draws the epipolar lines of both ends of a segment in another image. */
function paintEpipolar(v: number, canvas: ImageCanvas, images: PatchImages, other: { view: number; segment: ImageSegment } | null): void {
  if (!other) return;
  const [x1, y1, x2, y2] = other.segment;
  for (const end of [[x1, y1], [x2, y2]] as Point2[]) {
    const curve = images.epipolarCurve(v, other.view, end);
    if (curve) canvas.curve(curve, { colour: okabeIto.purple, width: 1.2, dash: [4, 4] });
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// Both images: segments (Fig. 1), matches (Fig. 7) or reconstructed lines; the selected line with its
// epipolar lines.
import { classColour, okabeIto, selectionColour, verdictColours } from '../data/colours';
import { distanceToSegment, type Point2 } from '../data/geometry';
import type { ImageSegment } from '../data/schema';
import type { Review } from '../review/review';
import type { State } from '../state';
import { append, button, choice, h, replace } from '../ui/dom';
import { ImageCanvas, type Stroke } from './image_canvas';
import { PatchImages, type ViewIndex } from './patch_images';

type Layer = 'matches' | 'segments' | 'lines' | 'none';
const views: readonly ViewIndex[] = [0, 1];

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

export class ImagePair {
  readonly element = h('section', { id: 'images' });
  private readonly controls = h('div', { class: 'controls' });
  private readonly box = h('div', { class: 'pair' });
  private readonly legend = h('p', { class: 'legend' });
  private readonly note = h('p', { class: 'caption' });
  private canvases: ImageCanvas[] = [];
  private images: PatchImages | null = null;
  private layer: Layer = 'matches';

  constructor(private readonly state: State, private readonly review: Review) {
    append(this.element, h('h3', {}, 'Images'), this.controls, this.box, this.legend, this.note);
    state.onChange((now, before) => {
      if (now.match !== before.match) this.frameMatch();
      if (now.match !== null && before.match === null) this.element.scrollIntoView({ block: 'start' });
      if (now.patch === before.patch) this.draw();
    });
    review.onChange(() => { this.updateLegend(); this.draw(); });
  }

  show(images: PatchImages | null): void {
    this.images = images;
    this.canvases = [];
    if (!images) {
      replace(this.controls);
      replace(this.legend);
      this.note.textContent = '';
      replace(this.box, h('p', { class: 'caption' }, this.state.patch.notes.length > 0 ? 'The images of this patch are not in the report; see the notes above.' : 'This run had no images.'));
      return;
    }
    this.canvases = views.map((v) => {
      const view = images.images.views[v];
      return new ImageCanvas(images.pictures[v], [view.width_px, view.height_px], `Image ${view.id}`, (c) => this.paint(v, c), (x, reach) => this.click(v, x, reach));
    });
    replace(this.box, ...views.map((v) => h('figure', { id: `image-${v}` }, this.canvases[v]!.canvas,
      h('figcaption', { class: 'caption' }, `${images.images.views[v].id} (${images.images.views[v].file})`))));
    replace(this.controls,
      choice<Layer>('show', [{ value: 'matches', text: 'matches (Fig. 7)' }, { value: 'segments', text: 'segments (Fig. 1)' }, { value: 'lines', text: '3D lines, projected' }, { value: 'none', text: 'nothing' }],
        this.layer, (layer) => { this.layer = layer; this.updateLegend(); this.draw(); }),
      button('Fit', () => this.canvases.forEach((c) => c.fit())));
    this.note.textContent = images.images.views.some((v) => v.is_distorted)
      ? 'Segments are drawn where the image shows them; epipolar lines and projected lines are without the distortion of the lens.' : '';
    this.updateLegend();
  }

  draw(): void {
    for (const canvas of this.canvases) canvas.draw();
  }

  private updateLegend(): void {
    const { images } = this;
    if (!images) return;
    const items: HTMLElement[] = [];
    if (this.layer === 'segments') {
      items.push(legendItem('aligned with the epipolar line (up to 10°)', { colour: okabeIto.vermillion, width: 3 }), legendItem('not aligned', { colour: okabeIto.skyBlue, width: 1.5 }));
    } else if (this.layer === 'matches') {
      const counts = new Map<string, number>();
      for (const m of images.images.matches) {
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

  private paint(v: ViewIndex, canvas: ImageCanvas): void {
    const { images } = this;
    if (!images) return;
    if (this.layer === 'segments' || this.layer === 'matches') this.paintSegments(v, canvas, images);
    if (this.layer === 'matches') this.paintMatches(v, canvas, images);
    if (this.layer === 'lines') this.paintLines(v, canvas, images);
    this.paintSelected(v, canvas, images);
  }

  private paintSegments(v: ViewIndex, canvas: ImageCanvas, images: PatchImages): void {
    for (let i = 0; i < images.count(v); ++i) {
      const segment = images.segment(v, i)!;
      if (this.layer === 'matches') canvas.segment(segment, { colour: '#b4b4b490', width: 1 });
      else canvas.segment(segment, images.isAligned(v, i) ? { colour: okabeIto.vermillion, width: 2.5 } : { colour: okabeIto.skyBlue, width: 1.2 });
    }
  }

  private paintMatches(v: ViewIndex, canvas: ImageCanvas, images: PatchImages): void {
    for (const m of images.images.matches) {
      const segment = images.segment(v, v === 0 ? m.left : m.right);
      if (segment) canvas.segment(segment, strokeOf[this.review.verdictOf(m)]!);
    }
    for (const pair of this.review.missed()) {
      const segment = images.segment(v, pair[v]);
      if (segment) canvas.segment(segment, strokeOf['missed']!);
    }
  }

  private paintLines(v: ViewIndex, canvas: ImageCanvas, images: PatchImages): void {
    for (const line of this.state.method.lines) {
      const seen = images.projected(v, line);
      if (seen) canvas.segment(seen, line.class === 'aligned' ? { colour: okabeIto.vermillion, width: 1.6, dash: [7, 4] } : { colour: okabeIto.skyBlue, width: 1.6 });
    }
  }

  private paintSelected(v: ViewIndex, canvas: ImageCanvas, images: PatchImages): void {
    const { line } = this.state;
    const match = this.review.current();
    const pending = this.review.pending(v);
    if (pending !== null) {
      const segment = images.segment(v, pending);
      if (segment) canvas.segment(segment, { colour: okabeIto.yellow, width: 4, halo: true });
    }
    const own = match ? images.segment(v, v === 0 ? match.left : match.right) : line ? images.segmentOfLine(v, line) : null;
    const other = match ? images.segment((1 - v) as ViewIndex, v === 0 ? match.right : match.left) : line ? images.segmentOfLine((1 - v) as ViewIndex, line) : null;
    paintEpipolar(v, canvas, images, other);
    if (!match && line) {
      const seen = images.projected(v, line);
      if (seen) canvas.segment(seen, { colour: okabeIto.black, width: 1.5, dash: [3, 3], halo: true });
    }
    if (own) canvas.segment(own, { colour: selectionColour, width: 3, halo: true });
  }

  private click(v: ViewIndex, x: Point2, reach_px: number): void {
    const { images } = this;
    if (!images) return;
    let nearest: number | null = null;
    let distance = reach_px;
    for (let i = 0; i < images.count(v); ++i) {
      const d = distanceToSegment(x, images.segment(v, i)!);
      if (d < distance) [nearest, distance] = [i, d];
    }
    if (this.review.takesClick(v, nearest)) return;
    this.state.set({ line: nearest === null ? this.lineAt(v, x, reach_px) : this.state.lineOfSegment(v, nearest) });
  }

  /** The line at a place in an image. Lines of other tools have no segments in the report, but may state their own. */
  private lineAt(v: ViewIndex, x: Point2, reach_px: number): number | null {
    const { images } = this;
    let best: number | null = null;
    let distance = reach_px;
    this.state.method.lines.forEach((line, i) => {
      const segment: ImageSegment | null = images?.segmentOfLine(v, line) ?? images?.projected(v, line) ?? null;
      const d = segment ? distanceToSegment(x, segment) : Infinity;
      if (d < distance) [best, distance] = [i, d];
    });
    return best;
  }

  private frameMatch(): void {
    const match = this.review.current();
    if (!match || !this.images) return;
    this.canvases.forEach((canvas, v) => {
      const segment = this.images!.segment(v as ViewIndex, v === 0 ? match.left : match.right);
      if (segment) canvas.frame(segment);
    });
  }
}

/** Draws the epipolar lines of both ends of the other image's segment. */
export function paintEpipolar(v: ViewIndex, canvas: ImageCanvas, images: PatchImages, other: ImageSegment | null): void {
  if (!other) return;
  for (const end of [[other[0], other[1]], [other[2], other[3]]] as Point2[]) {
    canvas.infiniteLine(images.epipolar(v, end), { colour: okabeIto.purple, width: 1.2, dash: [4, 4] });
  }
}

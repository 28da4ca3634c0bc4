// SPDX-License-Identifier: BSD-3-Clause
// The selected line: its figures, its planes, and a chip from each image.
import { selectionColour } from '../data/colours';
import type { ImageSegment, Line, Patch } from '../data/schema';
import type { State } from '../state';
import { append, h, replace, table } from '../ui/dom';
import { fixed, metres, missing, percent, words } from '../ui/format';
import { surfaceSentence } from '../ui/surface_words';
import { ImageCanvas } from './image_canvas';
import { paintLine } from './image_pair';
import { sentenceOfViews, viewWords } from './line_in_view';
import type { PatchImages } from './patch_images';

/** A value with its 95 % interval. */
const plusMinus = (value_m: number, variance_m2: number): string => `${metres(value_m)} ± ${metres(1.96 * Math.sqrt(variance_m2))} m`;

function facts(line: Line, patch: Patch, images: PatchImages | null): HTMLElement {
  const rows: [string, string][] = [
    ['class', `${words(line.class)}, ${fixed(line.epipolar_angle_deg, 1)}° to the epipolar line`],
    ['status', words(line.status) + (line.reason ? `: ${line.reason}` : '')],
    ['kind', line.kind ?? missing],
    ['length', `${fixed(line.length_m, 2)} m`],
  ];
  const surface = surfaceSentence(line);
  if (surface) rows.push(['surface', surface]);
  const views = images ? sentenceOfViews(patch, line, images) : null;
  if (views) rows.push(['images', views]);
  if (line.mean_distance_m !== null) {
    rows.push(['distance', `${metres(line.mean_distance_m)} m on average, ${metres(line.max_distance_m)} m at most, signed ${metres(line.signed_mean_m)} m`],
      ['sigma', `line ${metres(line.sigma_line_m)} m, plane ${metres(line.sigma_plane_m)} m, z ${fixed(line.z, 2)}`]);
  }
  if (line.displacement) {
    const { horizontal_m, vertical_m, covariance_m2 } = line.displacement;
    rows.push(['horizontal', `${plusMinus(horizontal_m, covariance_m2[0][0])} across in plan`], ['vertical', `${plusMinus(vertical_m, covariance_m2[1][1])} at the same place in plan`]);
  } else if (typeof line.height_if_vertical_m === 'number') {
    rows.push(['vertical', `${metres(line.height_if_vertical_m)} m if the offset were vertical; a single plane cannot show its direction`]);
  }
  if (typeof line.true_error_m === 'number') rows.push(['true error', `${metres(line.true_error_m)} m`]);
  if (line.construction) rows.push(['made by', words(line.construction) + (line.n_points ? ` with ${line.n_points} artificial points` : '')]);
  if (line.flags.length > 0) rows.push(['flags', line.flags.map(words).join(', ')]);
  return h('dl', {}, ...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
}

function planes(line: Line): HTMLElement | null {
  if (line.planes.length === 0) return null;
  return table([
    { title: 'plane', number: true, cell: (p) => String(p.id) },
    { title: 'inliers', number: true, cell: (p) => String(p.n_inliers) },
    { title: 'RMS m', number: true, cell: (p) => metres(p.rms_m) },
    { title: 'coverage %', number: true, cell: (p) => percent(p.coverage) },
    { title: 'start m', number: true, cell: (p) => metres(p.start_distance_m) },
    { title: 'end m', number: true, cell: (p) => metres(p.end_distance_m) },
    { title: 'mean m', number: true, cell: (p) => metres(p.mean_distance_m) },
  ], line.planes, { id: 'line-planes' });
}

export class Details {
  readonly element = h('section', { id: 'details', 'aria-live': 'polite' });
  private images: PatchImages | null = null;

  constructor(private readonly state: State) {
    state.onChange(() => this.update());
  }

  show(images: PatchImages | null): void {
    this.images = images;
    this.update();
  }

  private update(): void {
    const { line } = this.state;
    if (!line) {
      replace(this.element, h('h3', {}, 'Selected line'), h('p', { class: 'caption' }, 'None. Click a line in 3D, in an image or in the table.'));
      return;
    }
    const chips = h('div', { class: 'chips' });
    replace(this.element, h('h3', {}, `Line ${line.id}`), facts(line, this.state.patch, this.images), planes(line), chips);
    for (const v of this.viewsOf(line)) this.addChip(v, line, chips);
    if (this.images?.areSeveral && chips.childElementCount > 0) append(this.element, h('p', { class: 'caption' }, legendOf(line, this.images)));
  }

  /** The images that show the line, its first one first, then the others that contain it. */
  private viewsOf(line: Line): number[] {
    const { images } = this;
    if (!images) return [];
    if (!images.areSeveral) return [0, 1];
    const shown = images.viewsOfLine(line);
    return [...shown, ...images.pictures.map((_, v) => v).filter((v) => !shown.includes(v) && line.views?.[v])];
  }

  private addChip(v: number, line: Line, parent: HTMLElement): void {
    const { images } = this;
    if (!images) return;
    const own = images.segmentsOfLine(v, line);
    const projected = images.projected(v, line);
    // with several images, a segment may be a small part of the line
    const parts = projected && (own.length === 0 || images.areSeveral) ? [...own, projected] : own;
    const shown = parts.length > 0 ? boxOf(parts) : null;
    if (!shown) return;
    const view = images.images.views[v]!;
    const chip = new ImageCanvas(images.pictures[v]!, [view.width_px, view.height_px], `Line ${line.id} in image ${view.id}`, (canvas) => {
      paintLine(v, canvas, images, line, 1.5, false);
      // a pair shows every line: the projection replaces an unknown segment
      if (own.length === 0 && projected && !images.areSeveral) canvas.segment(projected, { colour: selectionColour, width: 1.5 });
    });
    const words = viewWords(this.state.patch, line, v);
    append(parent, h('figure', { class: words?.disagrees ? 'disagrees' : undefined }, chip.canvas,
      h('figcaption', { class: 'caption' }, view.id, ...(words ? [': ', h('strong', {}, words.word), words.more ? `, ${words.more}` : ''] : []))));
    chip.frame(shown);
  }
}

/** Explains the lines in the chips. */
function legendOf(line: Line, images: PatchImages): string {
  const [first, second] = images.viewsOfLine(line).map((v) => images.images.views[v]!.id);
  const epipolar = second === undefined ? (first === undefined ? '' : `; violet: epipolar lines of the ends in ${first}`) : `; violet: epipolar lines of the ends in ${first} (in ${first}: of those in ${second})`;
  return `Magenta: image segments; black and white: projected 3D line${epipolar}.`;
}

/** The bounding box of segments, as its diagonal. */
function boxOf(segments: readonly ImageSegment[]): ImageSegment {
  if (segments.length === 1) return segments[0]!;
  const x = segments.flatMap((s) => [s[0], s[2]]);
  const y = segments.flatMap((s) => [s[1], s[3]]);
  return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)];
}

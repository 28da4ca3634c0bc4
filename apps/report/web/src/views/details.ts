// SPDX-License-Identifier: BSD-3-Clause
// The selected line: its figures, its planes, its chips of both images.
import { okabeIto, selectionColour } from '../data/colours';
import type { Line } from '../data/schema';
import type { State } from '../state';
import { append, h, replace, table } from '../ui/dom';
import { fixed, metres, missing, percent, words } from '../ui/format';
import { ImageCanvas } from './image_canvas';
import { paintEpipolar } from './image_pair';
import type { PatchImages, ViewIndex } from './patch_images';

/** A value with its 95 % interval. */
const plusMinus = (value_m: number, variance_m2: number): string => `${metres(value_m)} ± ${metres(1.96 * Math.sqrt(variance_m2))} m`;

function facts(line: Line): HTMLElement {
  const rows: [string, string][] = [
    ['class', `${words(line.class)}, ${fixed(line.epipolar_angle_deg, 1)}° to the epipolar line`],
    ['status', words(line.status) + (line.reason ? `: ${line.reason}` : '')],
    ['kind', line.kind ?? missing],
    ['length', `${fixed(line.length_m, 2)} m`],
  ];
  if (line.mean_distance_m !== null) {
    rows.push(['distance', `${metres(line.mean_distance_m)} m on average, ${metres(line.max_distance_m)} m at most, signed ${metres(line.signed_mean_m)} m`],
      ['sigma', `line ${metres(line.sigma_line_m)} m, plane ${metres(line.sigma_plane_m)} m, z ${fixed(line.z, 2)}`]);
  }
  if (line.displacement) {
    const { horizontal_m, vertical_m, covariance_m2 } = line.displacement;
    rows.push(['horizontal', `${plusMinus(horizontal_m, covariance_m2[0][0])} across in plan`], ['vertical', `${plusMinus(vertical_m, covariance_m2[1][1])} at the same place in plan`]);
  } else if (typeof line.height_if_vertical_m === 'number') {
    rows.push(['vertical', `${metres(line.height_if_vertical_m)} m if the offset were vertical: one plane cannot tell`]);
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
    replace(this.element, h('h3', {}, `Line ${line.id}`), facts(line), planes(line), chips);
    for (const v of [0, 1] as const) this.addChip(v, line, chips);
  }

  private addChip(v: ViewIndex, line: Line, parent: HTMLElement): void {
    const { images } = this;
    const segment = images?.segmentOfLine(v, line) ?? images?.projected(v, line);
    if (!images || !segment) return;
    const view = images.images.views[v];
    const chip = new ImageCanvas(images.pictures[v], [view.width_px, view.height_px], `Line ${line.id} in image ${view.id}`, (canvas) => {
      paintEpipolar(v, canvas, images, images.segmentOfLine((1 - v) as ViewIndex, line));
      const seen = images.projected(v, line);
      if (seen) canvas.segment(seen, { colour: okabeIto.black, width: 1.5, dash: [3, 3], halo: true });
      canvas.segment(segment, { colour: selectionColour, width: 1.5 });
    });
    append(parent, h('figure', {}, chip.canvas, h('figcaption', { class: 'caption' }, view.id)));
    chip.frame(segment);
  }
}

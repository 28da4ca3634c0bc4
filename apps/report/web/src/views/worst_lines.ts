// SPDX-License-Identifier: BSD-3-Clause
// The lines farthest off, each with a detail of the image and a cross-section through the laser
// points.
import { planeColour, selectionColour } from '../data/colours';
import { uint16 } from '../data/decode';
import { halfSentence, headline, isOfFiles, worstLines } from '../data/product';
import type { Line, Method, Patch, Points } from '../data/schema';
import type { State } from '../state';
import { button, h, replace } from '../ui/dom';
import { metres, words } from '../ui/format';
import { surfaceWords } from '../ui/surface_words';
import { PatchImages } from './patch_images';

const fewestLines = 5;
const mostLines = 12;
const size: readonly [number, number] = [200, 130];

function canvas(label: string): { element: HTMLCanvasElement; g: CanvasRenderingContext2D } {
  const element = h('canvas', { width: 2 * size[0], height: 2 * size[1], 'aria-label': label, role: 'img' });
  const g = element.getContext('2d')!;
  g.scale(2, 2);
  return { element, g };
}

/** The image around the line's segment, with the segment drawn in it. */
function crop(images: PatchImages, line: Line): HTMLCanvasElement | null {
  const v = images.areSeveral ? (images.viewsOfLine(line)[0] ?? 0) : 0;
  const segment = images.segmentsOfLine(v, line)[0] ?? images.projected(v, line);
  if (!segment) return null;
  const { element, g } = canvas(`Image around line ${line.id}`);
  const [x1, y1, x2, y2] = segment;
  const length = Math.hypot(x2 - x1, y2 - y1);
  const scale = Math.min(3, (0.7 * Math.min(...size)) / Math.max(length, 1));
  const toCanvas = (x: number, y: number): [number, number] => [(x - (x1 + x2) / 2) * scale + size[0] / 2, (y - (y1 + y2) / 2) * scale + size[1] / 2];
  const view = images.images.views[v]!;
  const picture = images.pictures[v]!;
  const draw = (): void => {
    const [left, top] = toCanvas(-0.5, -0.5);
    g.drawImage(picture, left, top, view.width_px * scale, view.height_px * scale);
    g.strokeStyle = selectionColour;
    g.lineWidth = 1.5;
    g.beginPath();
    g.moveTo(...toCanvas(x1, y1));
    g.lineTo(...toCanvas(x2, y2));
    g.stroke();
  };
  if (picture.complete) draw();
  else picture.addEventListener('load', draw);
  return element;
}

/** The laser points between the ends of the line and within 6 m of it, seen along the line, which
 * appears as a cross. */
function section(points: Points, positions: Uint16Array, planeOfPoint: Uint16Array, line: Line): HTMLCanvasElement | null {
  if (!line.start || !line.end) return null;
  const reach_m = 6;
  const d = [line.end[0] - line.start[0], line.end[1] - line.start[1]];
  const length = Math.hypot(d[0]!, d[1]!);
  if (!(length > 0)) return null;
  const [ux, uy] = [d[0]! / length, d[1]! / length];
  const z0 = (line.start[2] + line.end[2]) / 2;
  const surface = surfaceWords(line);
  const { element, g } = canvas(`Section across line ${line.id}${surface ? `, edge of: ${surface}` : ''}`);
  const scale = size[0] / (2 * reach_m);
  const found: { t: number; z: number; plane: number }[] = [];
  for (let i = 0; i < positions.length / 3; ++i) {
    const x = points.low[0] + positions[3 * i]! * points.step[0] - line.start[0];
    const y = points.low[1] + positions[3 * i + 1]! * points.step[1] - line.start[1];
    const s = x * ux + y * uy;
    const t = y * ux - x * uy;
    if (s < 0 || s > length || Math.abs(t) > reach_m) continue;
    found.push({ t, z: points.low[2] + positions[3 * i + 2]! * points.step[2], plane: planeOfPoint[i]! });
  }
  if (found.length === 0) return null;
  // the middle is between the line and the points nearest to it in height, so that both are in the
  // picture if possible
  const nearest = found.map((p) => p.z).sort((a, b) => Math.abs(a - z0) - Math.abs(b - z0))[Math.floor(found.length / 4)]!;
  const middle = (z0 + nearest) / 2;
  const toCanvas = (t: number, z: number): [number, number] => [size[0] / 2 + t * scale, size[1] / 2 - (z - middle) * scale];
  for (const p of found) {
    const [x, y] = toCanvas(p.t, p.z);
    g.fillStyle = p.plane === 0 ? '#9a9a9a' : planeColour(p.plane - 1, true);
    g.fillRect(x - 1, y - 1, 2, 2);
  }
  const [x, y] = toCanvas(0, z0);
  g.strokeStyle = selectionColour;
  g.lineWidth = 2;
  for (const [dx, dy] of [[5, 5], [5, -5]] as const) {
    g.beginPath();
    g.moveTo(x - dx, y - dy);
    g.lineTo(x + dx, y + dy);
    g.stroke();
  }
  g.fillStyle = '#666';
  g.fillRect(4, size[1] - 6, 2 * scale, 2);
  g.font = '9px sans-serif';
  g.fillText('2 m', 6 + 2 * scale, size[1] - 3);
  if (surface) g.fillText(`edge of: ${surface}`, 4, 11);
  return element;
}

export class WorstLines {
  readonly element = h('div', { id: 'worst' });

  constructor(private readonly state: State) {}

  show(patch: Patch, method: Method): void {
    const total = method.summary['total'];
    const figures = total ? headline(total) : null;
    const worst = worstLines(method.lines, Math.max(fewestLines, Math.min(mostLines, figures?.n_half_of_squares ?? 0)));
    if (worst.length === 0) {
      replace(this.element);
      return;
    }
    const images = PatchImages.of(patch, () => undefined);
    const positions = patch.points ? uint16(patch.points.positions) : null;
    const planeOfPoint = uint16(method.plane_of_point);
    const pictures = (line: Line): (HTMLCanvasElement | null)[] => [
      images ? crop(images, line) : null,
      patch.points && positions ? section(patch.points, positions, planeOfPoint, line) : null,
    ];
    replace(this.element, h('h3', {}, `The ${worst.length} worst lines of patch ${patch.id}, ${isOfFiles(this.state.report) ? '' : 'method '}${method.name}`),
      figures ? h('p', { class: 'caption', id: 'half-of-squares' }, `${halfSentence(figures)}.${(figures.n_half_of_squares ?? 0) > worst.length ? ` Shown: the first ${worst.length}.` : ''}`) : null,
      ...worst.map(({ line, index }, i) => h('figure', { class: i < fewestLines ? 'worst-line' : 'worst-line further' },
        h('figcaption', {}, button(line.id, () => this.state.set({ line: index }), { class: 'plain', title: 'select the line' }),
          ` ${metres(line.mean_distance_m)} m, ${words(line.class)}, ${line.kind ?? ''}${surfaceWords(line) ? `, edge of: ${surfaceWords(line)}` : ''}${line.flags.length > 0 ? `, ${line.flags.map(words).join(', ')}` : ''}`),
        ...pictures(line))),
      h('p', { class: 'caption' }, images ? `Left: ${images.areSeveral ? 'the first image that shows the line' : 'the base image'}. Right: the LIDAR points seen along the line` : 'The LIDAR points seen along the line', ', coloured by plane; the cross is the line. A line metres away from all points is either wrong itself or was judged against the wrong surface.'));
  }
}

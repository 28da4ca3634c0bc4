// SPDX-License-Identifier: BSD-3-Clause
// The decoded images of a patch with their segments, shared by the image panel, the chips and the
// review.
import { float32, uint8 } from '../data/decode';
import { epipolarLine, project, type Point2 } from '../data/geometry';
import { clipLine, clipSegment, curveOf, distorted, idealBox, undistorted, type Box } from '../data/lens';
import type { Images, ImageSegment, Line, Match, PairOfViews, Patch } from '../data/schema';

/** Which segment of a match is in an image, 0 (left) or 1 (right); null for an image outside the
 * pair. */
export const sideOf = (pair: PairOfViews, view: number): 0 | 1 | null => (view === pair.base ? 0 : view === pair.search ? 1 : null);

export class PatchImages {
  readonly pictures: HTMLImageElement[];
  /** All pairs of images: those that were matched, the base pair first, then the others. */
  readonly pairs: PairOfViews[];
  private readonly segments: Float32Array[];
  private readonly aligned: (Uint8Array | null)[][];
  private readonly boxes: Box[];

  constructor(readonly images: Images, onload: () => void) {
    this.pictures = images.views.map((view) => {
      const image = new Image();
      image.onload = onload;
      image.src = `data:image/jpeg;base64,${view.jpeg}`;
      return image;
    });
    this.segments = images.views.map((view) => float32(view.segments));
    this.aligned = images.views.map((view) => view.aligned.map((bits) => (bits ? uint8(bits) : null)));
    this.boxes = images.views.map((view) => idealBox(view.lens, view.width_px, view.height_px));
    this.pairs = [...images.pairs];
    for (let base = 0; base < this.count; ++base) {
      for (let search = base + 1; search < this.count; ++search) {
        if (this.pairOf(base, search) < 0) this.pairs.push({ base, search, matches: this.matchesOfTracks(base, search), missed: [] });
      }
    }
  }

  static of(patch: Patch, onload: () => void): PatchImages | null {
    return patch.images ? new PatchImages(patch.images, onload) : null;
  }

  /** The number of images. */
  get count(): number {
    return this.images.views.length;
  }
  /** Whether there are more than two images, so that the page must say which ones it shows. */
  get areSeveral(): boolean {
    return this.count > 2;
  }

  /** The index of the pair of two images, -1 if there is none. */
  pairOf(a: number, b: number): number {
    return this.pairs.findIndex((p) => (p.base === a && p.search === b) || (p.base === b && p.search === a));
  }
  /** Whether the program matched the pair itself; the matches of other pairs are derived from
   * tracks. */
  wasMatched(pair: number): boolean {
    return pair < this.images.pairs.length;
  }
  nameOfPair(pair: PairOfViews, between = ' – '): string {
    return `${this.images.views[pair.base]!.id}${between}${this.images.views[pair.search]!.id}`;
  }

  private matchesOfTracks(base: number, search: number): Match[] {
    const matches: Match[] = [];
    for (const track of this.images.tracks) {
      const segmentIn = (view: number): number | undefined => {
        for (let i = 0; i < track.length; i += 2) if (track[i] === view) return track[i + 1];
        return undefined;
      };
      const [left, right] = [segmentIn(base), segmentIn(search)];
      if (left !== undefined && right !== undefined) matches.push({ left, right });
    }
    return matches;
  }

  countOf(view: number): number {
    return this.segments[view]!.length / 4;
  }
  segment(view: number, i: number): ImageSegment | null {
    const s = this.segments[view]!.subarray(4 * i, 4 * i + 4);
    return s.length === 4 ? [s[0]!, s[1]!, s[2]!, s[3]!] : null;
  }
  /** Whether a segment is aligned with its epipolar line for another image. */
  isAligned(view: number, other: number, i: number): boolean {
    return (((this.aligned[view]![other]?.[i >> 3] ?? 0) >> (i & 7)) & 1) === 1;
  }

  /** The line's segments in an image: the extracted ones, otherwise those given in its file. */
  segmentsOfLine(view: number, line: Line): ImageSegment[] {
    return (line.observations ?? []).filter((s) => s[0] === view)
      .map(([, index, px]) => (index === null ? null : this.segment(view, index)) ?? this.inPicture(view, px)).filter((s) => s !== null);
  }
  /** Converts the ends of a segment from ideal pixels to pixels of the picture. */
  private inPicture(view: number, px: ImageSegment | null): ImageSegment | null {
    const { lens } = this.images.views[view]!;
    return px && [...distorted(lens, [px[0], px[1]]), ...distorted(lens, [px[2], px[3]])];
  }

  /** The images that show a line, in the order of its segments. */
  viewsOfLine(line: Line): number[] {
    return [...new Set((line.observations ?? []).map((s) => s[0]))].filter((view) => this.segmentsOfLine(view, line).length > 0);
  }

  /** The segment whose epipolar lines are drawn for a line in an image: its first segment in
   * another image. */
  partnerOf(view: number, line: Line): { view: number; segment: ImageSegment } | null {
    const other = this.viewsOfLine(line).find((v) => v !== view);
    const segment = other === undefined ? undefined : this.segmentsOfLine(other, line)[0];
    return other === undefined || !segment ? null : { view: other, segment };
  }

  /** The projection of the 3D line in ideal pixels, limited to the part that the picture can show
   * if the lens distorts. */
  private ideal(view: number, line: Line): ImageSegment | null {
    const [start, end] = [line.seen_start ?? line.start, line.seen_end ?? line.end];
    if (!start || !end) return null;
    const { projection, lens } = this.images.views[view]!;
    const whole: ImageSegment = [...project(projection, start), ...project(projection, end)];
    return lens ? clipSegment(whole, this.boxes[view]!) : whole;
  }
  /** The ends of the 3D line in the picture. */
  projected(view: number, line: Line): ImageSegment | null {
    return this.inPicture(view, this.ideal(view, line));
  }
  /** The 3D line in the picture: a curve if the lens distorts. */
  projectedCurve(view: number, line: Line): Point2[] | null {
    const ideal = this.ideal(view, line);
    return ideal && curveOf(this.images.views[view]!.lens, ideal);
  }

  /** The epipolar line in `view` of a point in the picture of another image: a curve if the lens
   * distorts. */
  epipolarCurve(view: number, other: number, xInOther: Point2): Point2[] | null {
    const [own, from] = [this.images.views[view]!, this.images.views[other]!];
    const part = clipLine(epipolarLine(own.projection, from.projection, undistorted(from.lens, xInOther)), this.boxes[view]!);
    return part && curveOf(own.lens, part);
  }
}

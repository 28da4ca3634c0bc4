// SPDX-License-Identifier: BSD-3-Clause
// The decoded images of a patch with their segments, shared by the images, the chips and the review.
import { float32, uint8 } from '../data/decode';
import { epipolarLine, project, type LineCoefficients, type Point2 } from '../data/geometry';
import type { Images, ImageSegment, Line, Match, PairOfViews, Patch } from '../data/schema';

/** Which segment of a match an image shows; null for an image that is none of the pair's. */
export const sideOf = (pair: PairOfViews, view: number): 0 | 1 | null => (view === pair.base ? 0 : view === pair.search ? 1 : null);

export class PatchImages {
  readonly pictures: HTMLImageElement[];
  /** All pairs of images: those that were matched, the base pair first, then the others. */
  readonly pairs: PairOfViews[];
  private readonly segments: Float32Array[];
  private readonly aligned: (Uint8Array | null)[][];

  constructor(readonly images: Images, onload: () => void) {
    this.pictures = images.views.map((view) => {
      const image = new Image();
      image.onload = onload;
      image.src = `data:image/jpeg;base64,${view.jpeg}`;
      return image;
    });
    this.segments = images.views.map((view) => float32(view.segments));
    this.aligned = images.views.map((view) => view.aligned.map((bits) => (bits ? uint8(bits) : null)));
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
  /** Whether the page has to say which of several images it shows. */
  get areSeveral(): boolean {
    return this.count > 2;
  }

  /** The index of the pair of two images, -1 if there is none. */
  pairOf(a: number, b: number): number {
    return this.pairs.findIndex((p) => (p.base === a && p.search === b) || (p.base === b && p.search === a));
  }
  /** Whether the program matched the pair itself; of others only tracks tell matches. */
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

  /** The line's segments in an image: the extracted ones, else those that its file states. */
  segmentsOfLine(view: number, line: Line): ImageSegment[] {
    return (line.sightings ?? []).filter((s) => s[0] === view)
      .map(([, index, px]) => (index === null ? null : this.segment(view, index)) ?? px).filter((s) => s !== null);
  }

  /** The images that show a line, the first of its segments first. */
  viewsOfLine(line: Line): number[] {
    return [...new Set((line.sightings ?? []).map((s) => s[0]))].filter((view) => this.segmentsOfLine(view, line).length > 0);
  }

  /** The segment whose epipolar lines an image shows of a line: its first one, or in that one's image that of another. */
  partnerOf(view: number, line: Line): { view: number; segment: ImageSegment } | null {
    const other = this.viewsOfLine(line).find((v) => v !== view);
    const segment = other === undefined ? undefined : this.segmentsOfLine(other, line)[0];
    return other === undefined || !segment ? null : { view: other, segment };
  }

  /** The 3D line as the camera sees it. */
  projected(view: number, line: Line): ImageSegment | null {
    if (!line.start || !line.end) return null;
    const P = this.images.views[view]!.projection;
    return [...project(P, line.start), ...project(P, line.end)];
  }

  /** Epipolar line in `view` of a point of another image. */
  epipolar(view: number, other: number, xInOther: Point2): LineCoefficients {
    return epipolarLine(this.images.views[view]!.projection, this.images.views[other]!.projection, xInOther);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// The decoded images of a patch with their segments, shared by the image pair, the chips and the review.
import { float32 } from '../data/decode';
import { epipolarLine, project, type LineCoefficients, type Point2 } from '../data/geometry';
import type { Images, ImageSegment, Line, Match, Patch } from '../data/schema';

export type ViewIndex = 0 | 1;

export class PatchImages {
  readonly pictures: [HTMLImageElement, HTMLImageElement];
  private readonly segments: [Float32Array, Float32Array];
  private readonly angles: [Float32Array, Float32Array];
  private readonly matchesOf: [Map<number, Match>, Map<number, Match>] = [new Map(), new Map()];

  constructor(readonly images: Images, onload: () => void) {
    const picture = (i: ViewIndex): HTMLImageElement => {
      const image = new Image();
      image.onload = onload;
      image.src = `data:image/jpeg;base64,${images.views[i].jpeg}`;
      return image;
    };
    this.pictures = [picture(0), picture(1)];
    this.segments = [float32(images.views[0].segments), float32(images.views[1].segments)];
    this.angles = [float32(images.views[0].angles_deg), float32(images.views[1].angles_deg)];
    for (const match of images.matches) {
      this.matchesOf[0].set(match.left, match);
      this.matchesOf[1].set(match.right, match);
    }
  }

  static of(patch: Patch, onload: () => void): PatchImages | null {
    return patch.images ? new PatchImages(patch.images, onload) : null;
  }

  count(view: ViewIndex): number {
    return this.segments[view].length / 4;
  }
  segment(view: ViewIndex, i: number): ImageSegment | null {
    const s = this.segments[view].subarray(4 * i, 4 * i + 4);
    return s.length === 4 ? [s[0]!, s[1]!, s[2]!, s[3]!] : null;
  }
  isAligned(view: ViewIndex, i: number): boolean {
    return (this.angles[view][i] ?? 90) <= 10;
  }
  matchOf(view: ViewIndex, segment: number): Match | null {
    return this.matchesOf[view].get(segment) ?? null;
  }

  /** The line's segment in an image: the extracted one, else the one that its file states. */
  segmentOfLine(view: ViewIndex, line: Line): ImageSegment | null {
    const index = view === 0 ? line.left : line.right;
    const extracted = typeof index === 'number' ? this.segment(view, index) : null;
    return extracted ?? (view === 0 ? line.left_px : line.right_px) ?? null;
  }

  /** The 3D line as the camera sees it. */
  projected(view: ViewIndex, line: Line): ImageSegment | null {
    if (!line.start || !line.end) return null;
    const P = this.images.views[view].projection;
    return [...project(P, line.start), ...project(P, line.end)];
  }

  /** Epipolar line in `view` of a point of the other image. */
  epipolar(view: ViewIndex, xInOther: Point2): LineCoefficients {
    return epipolarLine(this.images.fundamental, xInOther, view === 0);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
import { noPlaneColour, planeColour, surfaceColour } from '../data/colours';
import { uint16 } from '../data/decode';
import type { Method, PointSet } from '../data/schema';

/** Points of one class, by their index, have one colour, which may depend on the theme. */
export interface PointColours {
  classOf: (point: number) => number;
  colourOf: (pointClass: number) => string;
}

/** Colours points by the plane that lines were judged by; 0: none. */
export function planeColours(method: Method): PointColours {
  const planes = uint16(method.plane_of_point);
  return { classOf: (point) => planes[point]!, colourOf: (plane) => (plane === 0 ? noPlaneColour() : planeColour(plane - 1)) };
}

/** Colours points by height, in steps over the range of all but a few points, as matching errs by
 * many metres at times. */
export function heightColours(points: PointSet): PointColours {
  const steps = 16;
  const heights = uint16(points.positions).filter((_, i) => i % 3 === 2);
  const sorted = heights.slice().sort();
  const low = sorted[Math.floor(0.02 * sorted.length)]!;
  const high = sorted[Math.floor(0.98 * sorted.length)]!;
  return {
    classOf: (point) => Math.min(steps - 1, Math.max(0, Math.floor((steps * (heights[point]! - low)) / (high - low + 1)))),
    colourOf: (step) => surfaceColour(step / (steps - 1)),
  };
}

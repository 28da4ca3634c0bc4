// SPDX-License-Identifier: BSD-3-Clause
import { noPlaneColour, planeColour, surfaceColour } from '../data/colours';
import { uint16 } from '../data/decode';
import type { Method, PointSet } from '../data/schema';

/** Assigns a class to each point, by its index, and to each class a colour, which may depend on the
 * theme. */
export interface PointColours {
  classOf: (point: number) => number;
  colourOf: (pointClass: number) => string;
}

/** Colours points by the plane against which lines were judged; 0: none. */
export function planeColours(method: Method): PointColours {
  const planes = uint16(method.plane_of_point);
  return { classOf: (point) => planes[point]!, colourOf: (plane) => (plane === 0 ? noPlaneColour() : planeColour(plane - 1)) };
}

/** Colours points by height, in steps over the range of all but a few points, because matching
 * errors can reach many metres. */
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

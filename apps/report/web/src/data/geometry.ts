// SPDX-License-Identifier: BSD-3-Clause
import type { ImageSegment, Triple } from './schema';

export type Point2 = [number, number];
export type LineCoefficients = [number, number, number];

/** Pixel of a local point; P is stored row by row. */
export function project(P: readonly number[], x: Triple): Point2 {
  const row = (r: number): number =>
    P[4 * r]! * x[0] + P[4 * r + 1]! * x[1] + P[4 * r + 2]! * x[2] + P[4 * r + 3]!;
  return [row(0) / row(2), row(1) / row(2)];
}

/** The epipolar line F x of a left point in the right image; `transposed`: that of a right point in the left image. */
export function epipolarLine(F: readonly number[], x: Point2, transposed: boolean): LineCoefficients {
  const at = (r: number, c: number): number => (transposed ? F[3 * c + r]! : F[3 * r + c]!);
  const row = (r: number): number => at(r, 0) * x[0] + at(r, 1) * x[1] + at(r, 2);
  return [row(0), row(1), row(2)];
}

/** The part of a line within a rectangle, if any. */
export function clipToBox([a, b, c]: LineCoefficients, width: number, height: number): ImageSegment | null {
  const points: Point2[] = [];
  const add = (x: number, y: number): void => {
    const inside = x >= -1e-6 && x <= width + 1e-6 && y >= -1e-6 && y <= height + 1e-6;
    if (inside && !points.some((p) => Math.hypot(p[0] - x, p[1] - y) < 1e-3)) points.push([x, y]);
  };
  if (Math.abs(b) > 1e-12) {
    add(0, -c / b);
    add(width, -(c + a * width) / b);
  }
  if (Math.abs(a) > 1e-12) {
    add(-c / a, 0);
    add(-(c + b * height) / a, height);
  }
  const [p, q] = points;
  return p && q ? [p[0], p[1], q[0], q[1]] : null;
}

export function distanceToSegment(x: Point2, [x1, y1, x2, y2]: ImageSegment): number {
  const dx = x2 - x1;
  const dy = y2 - y1;
  const squared = dx * dx + dy * dy;
  const t = squared > 0 ? Math.min(1, Math.max(0, ((x[0] - x1) * dx + (x[1] - y1) * dy) / squared)) : 0;
  return Math.hypot(x[0] - x1 - t * dx, x[1] - y1 - t * dy);
}

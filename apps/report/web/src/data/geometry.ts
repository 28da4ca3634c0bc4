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

const cross = (a: Triple, b: Triple): Triple =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The line in the image of camera P on which points on the ray of pixel x of camera Q appear: the
 * join of the images of Q's centre -M^-1 q and of the ray's direction M^-1 x, where Q = [M | q].
 * Both cameras are stored row by row. */
export function epipolarLine(P: readonly number[], Q: readonly number[], x: Point2): LineCoefficients {
  const column = (c: number): Triple => [Q[c]!, Q[4 + c]!, Q[8 + c]!];
  const [a, b, c, q] = [column(0), column(1), column(2), column(3)];
  const det = dot(a, cross(b, c));
  const solve = (y: Triple): Triple => [dot(y, cross(b, c)) / det, dot(y, cross(c, a)) / det, dot(y, cross(a, b)) / det];
  const image = (v: Triple, w: number): Triple => {
    const row = (r: number): number => P[4 * r]! * v[0] + P[4 * r + 1]! * v[1] + P[4 * r + 2]! * v[2] + P[4 * r + 3]! * w;
    return [row(0), row(1), row(2)];
  };
  const centre = solve(q);
  const line = cross(image([-centre[0], -centre[1], -centre[2]], 1), image(solve([x[0], x[1], 1]), 0));
  const norm = Math.hypot(line[0], line[1]);
  return [line[0] / norm, line[1] / norm, line[2] / norm];
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

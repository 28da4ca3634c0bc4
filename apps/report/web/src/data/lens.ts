// SPDX-License-Identifier: BSD-3-Clause
// Lens distortion: conversion between ideal pixels, in which lines in space are straight, and
// pixels of the picture.
import type { LineCoefficients, Point2 } from './geometry';
import { clipToBox } from './geometry';
import type { ImageSegment, Lens } from './schema';

/** A box in ideal pixels: left, top, right, bottom. */
export type Box = [number, number, number, number];

/** The position of an ideal pixel in the picture (Brown 1971, as defined in docs/patch-file.md). */
export function distorted(lens: Lens | null, x: Point2): Point2 {
  if (!lens) return x;
  const [fx, fy, cx, cy, k1, k2, k3, p1, p2] = lens;
  const [u, v] = [(x[0] - cx) / fx, (x[1] - cy) / fy];
  const rr = u * u + v * v;
  const radial = 1 + rr * (k1 + rr * (k2 + rr * k3));
  return [
    cx + fx * (u * radial + 2 * p1 * u * v + p2 * (rr + 2 * u * u)),
    cy + fy * (v * radial + p1 * (rr + 2 * v * v) + 2 * p2 * u * v),
  ];
}

/** The ideal pixel of a pixel of the picture, by iteration; accurate to a thousandth of a pixel
 * within the field of view of a lens. */
export function undistorted(lens: Lens | null, x: Point2): Point2 {
  if (!lens) return x;
  let ideal = x;
  for (let i = 0; i < 50; ++i) {
    const seen = distorted(lens, ideal);
    const [dx, dy] = [x[0] - seen[0], x[1] - seen[1]];
    ideal = [ideal[0] + dx, ideal[1] + dy];
    if (Math.hypot(dx, dy) < 1e-4) break;
  }
  return ideal;
}

/** The box of ideal pixels around everything that a picture shows. Farther out, the polynomials are
 * meaningless. */
export function idealBox(lens: Lens | null, width: number, height: number): Box {
  const border: Point2[] = [];
  const n = 16;
  for (let i = 0; i <= n; ++i) {
    const [x, y] = [(i / n) * (width - 1), (i / n) * (height - 1)];
    for (const p of [[x, 0], [x, height - 1], [0, y], [width - 1, y]] as Point2[]) border.push(undistorted(lens, p));
  }
  const [xs, ys] = [border.map((p) => p[0]), border.map((p) => p[1])];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** The part of a segment within a box, if any. */
export function clipSegment([x1, y1, x2, y2]: ImageSegment, [left, top, right, bottom]: Box): ImageSegment | null {
  let [from, to] = [0, 1];
  const [dx, dy] = [x2 - x1, y2 - y1];
  for (const [step, room] of [[-dx, x1 - left], [dx, right - x1], [-dy, y1 - top], [dy, bottom - y1]] as Point2[]) {
    if (step === 0 && room < 0) return null;
    if (step < 0) from = Math.max(from, room / step);
    if (step > 0) to = Math.min(to, room / step);
  }
  return from < to ? [x1 + from * dx, y1 + from * dy, x1 + to * dx, y1 + to * dy] : null;
}

/** The part of a line within a box, if any. */
export function clipLine([a, b, c]: LineCoefficients, [left, top, right, bottom]: Box): ImageSegment | null {
  const part = clipToBox([a, b, c + a * left + b * top], right - left, bottom - top);
  return part && [part[0] + left, part[1] + top, part[2] + left, part[3] + top];
}

/** The curve in the picture that corresponds to a segment in ideal pixels. */
export function curveOf(lens: Lens | null, [x1, y1, x2, y2]: ImageSegment): Point2[] {
  if (!lens) return [[x1, y1], [x2, y2]];
  const n = Math.min(64, Math.max(2, Math.ceil(Math.hypot(x2 - x1, y2 - y1) / 25)));
  return Array.from({ length: n + 1 }, (_, i) => distorted(lens, [x1 + (i / n) * (x2 - x1), y1 + (i / n) * (y2 - y1)]));
}

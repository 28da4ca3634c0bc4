// SPDX-License-Identifier: BSD-3-Clause
import { BufferAttribute, BufferGeometry, Color, Points, PointsMaterial, Vector3 } from 'three';
import { isDark } from '../data/colours';
import { uint16 } from '../data/decode';
import type { PointSet } from '../data/schema';
import type { PointColours } from './point_colours';

/** Returns the screen position of a point and its depth; null if it is not visible. */
type Project = (x: Vector3) => [number, number, number] | null;

type Bytes = [number, number, number];

/** A colour in the renderer's linear scale. On a dark background it is dimmed, so that lines stand
 * out. */
const bytesOf = (colour: string): Bytes => new Color(colour).multiplyScalar(isDark() ? 0.3 : 1).toArray().map((v) => Math.round(255 * v)) as Bytes;

/** A permutation of 0 .. n-1 that separates neighbours, so that any initial part covers the whole
 * evenly. */
function spread(n: number): (i: number) => number {
  const step = [7919, 7907, 7901].find((prime) => n % prime !== 0) ?? 1;
  return (i) => (i * step) % n;
}

/** Points of one source, LIDAR or surface. */
export class PointLayer {
  readonly object = new Points(new BufferGeometry(), new PointsMaterial({ size: 3, sizeAttenuation: false, vertexColors: true }));
  private positions = new Uint16Array();
  private source: PointSet | null = null;
  private colours: PointColours | null = null;

  show(points: PointSet | null, colours: PointColours | null): void {
    this.colours = colours;
    if (points !== this.source) {
      this.source = points;
      this.positions = points ? uint16(points.positions) : new Uint16Array();
      const n = this.positions.length / 3;
      // four values per point, because graphics memory is read in words
      const padded = new Uint16Array(4 * n);
      const from = spread(n);
      for (let i = 0; i < n; ++i) padded.set(this.positions.subarray(3 * from(i), 3 * from(i) + 3), 4 * i);
      this.object.geometry.dispose();
      this.object.geometry = new BufferGeometry();
      this.object.geometry.setAttribute('position', new BufferAttribute(padded, 4));
      this.object.frustumCulled = false;
      if (points) {
        this.object.scale.set(...points.step);
        this.object.position.set(...points.low);
      }
      this.object.material.size = n > 60000 ? 2 : 3;
    }
    this.applyTheme();
  }

  applyTheme(): void {
    if (!this.colours) return;
    const { classOf, colourOf } = this.colours;
    const n = this.positions.length / 3;
    const colours = new Uint8Array(4 * n).fill(255);
    const palette = new Map<number, Bytes>();
    const from = spread(n);
    for (let i = 0; i < n; ++i) {
      const pointClass = classOf(from(i));
      let colour = palette.get(pointClass);
      if (!colour) palette.set(pointClass, (colour = bytesOf(colourOf(pointClass))));
      colours.set(colour, 4 * i);
    }
    this.object.geometry.setAttribute('color', new BufferAttribute(colours, 4, true));
  }

  /** Draws only this share of the points, evenly distributed. */
  thin(share: number): void {
    this.object.geometry.setDrawRange(0, share < 1 ? Math.ceil((share * this.positions.length) / 3) : Infinity);
  }

  /** The point nearest to the eye among those shown within 8 pixels of a screen position. */
  pointNear(at: [number, number], project: Project): { x: Vector3; depth: number } | null {
    const { source } = this;
    if (!source || !this.object.visible) return null;
    const reach_px = 8;
    let found: { x: Vector3; depth: number } | null = null;
    const x = new Vector3();
    for (let i = 0; i < this.positions.length / 3; ++i) {
      x.set(...([0, 1, 2].map((a) => source.low[a]! + this.positions[3 * i + a]! * source.step[a]!) as [number, number, number]));
      const p = project(x);
      if (p && p[2] < (found?.depth ?? Infinity) && Math.hypot(p[0] - at[0], p[1] - at[1]) < reach_px) found = { x: x.clone(), depth: p[2] };
    }
    return found;
  }
}

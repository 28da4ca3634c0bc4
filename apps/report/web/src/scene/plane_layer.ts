// SPDX-License-Identifier: BSD-3-Clause
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Mesh, MeshBasicMaterial } from 'three';
import { planeColour, selectionColour } from '../data/colours';
import type { Method, Plane } from '../data/schema';

const material = (opacity: number): MeshBasicMaterial =>
  new MeshBasicMaterial({ vertexColors: true, transparent: true, opacity, side: DoubleSide, depthWrite: false });

/** Convex outlines as fans of triangles. */
function geometryOf(planes: readonly { plane: Plane; colour: string }[]): BufferGeometry {
  const positions: number[] = [];
  const colours: number[] = [];
  const value = new Color();
  for (const { plane, colour } of planes) {
    const [first, ...rest] = plane.outline;
    if (!first) continue;
    value.set(colour);
    for (let i = 0; i + 1 < rest.length; ++i) {
      positions.push(...first, ...rest[i]!, ...rest[i + 1]!);
      for (let k = 0; k < 3; ++k) colours.push(value.r, value.g, value.b);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 3));
  return geometry;
}

/** The planes as translucent patches; those of the selected line stand out. */
export class PlaneLayer {
  readonly object = new Group();
  private readonly all = new Mesh(new BufferGeometry(), material(0.16));
  private readonly chosen = new Mesh(new BufferGeometry(), material(0.45));
  private planes: readonly Plane[] = [];

  constructor() {
    this.all.frustumCulled = this.chosen.frustumCulled = false;
    this.all.visible = false;
    this.object.add(this.all, this.chosen);
  }

  show(method: Method): void {
    this.planes = method.planes;
    this.all.geometry.dispose();
    this.all.geometry = geometryOf(this.planes.map((plane, i) => ({ plane, colour: planeColour(i) })));
    this.highlight([]);
  }

  setVisible(visible: boolean): void {
    this.all.visible = visible;
  }

  highlight(ids: readonly number[]): void {
    this.chosen.geometry.dispose();
    this.chosen.geometry = geometryOf(this.planes.filter((p) => ids.includes(p.id)).map((plane) => ({ plane, colour: selectionColour })));
  }
}

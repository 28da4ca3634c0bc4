// SPDX-License-Identifier: BSD-3-Clause
import { Group, Vector3 } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { fixed } from '../ui/format';

/** Measures distances between two clicks on lines or points. */
export class Measure {
  readonly object = new Group();
  onChange: (text: string) => void = () => undefined;
  isOn = false;
  private ends: Vector3[] = [];
  private readonly line = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth: 2, color: 0xcc79a7, depthTest: false }));

  constructor() {
    this.line.visible = false;
    this.line.frustumCulled = false;
    this.line.renderOrder = 3;
    this.object.add(this.line);
  }

  turn(on: boolean): void {
    this.isOn = on;
    this.clear();
  }

  clear(): void {
    this.ends = [];
    this.line.visible = false;
    this.onChange(this.isOn ? 'Click two lines or points.' : '');
  }

  add(x: Vector3): void {
    if (this.ends.length === 2) this.clear();
    this.ends.push(x);
    const [a, b] = this.ends;
    if (!a || !b) {
      this.onChange('Click the second line or point.');
      return;
    }
    this.line.geometry.dispose();
    this.line.geometry = new LineSegmentsGeometry();
    this.line.geometry.setPositions([...a.toArray(), ...b.toArray()]);
    this.line.visible = true;
    const d = b.clone().sub(a);
    this.onChange(`Distance ${fixed(d.length(), 3)} m, in plan ${fixed(Math.hypot(d.x, d.y), 3)} m; east ${fixed(d.x, 3)}, north ${fixed(d.y, 3)}, up ${fixed(d.z, 3)} m.`);
  }

  setResolution(width: number, height: number): void {
    this.line.material.resolution.set(width, height);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// The worst buildings, each with a section across its longest edge and the reason for its verdict.
import { selectionColour } from '../data/colours';
import { uint16 } from '../data/decode';
import type { Building, Line, Points } from '../data/schema';
import { reasonOf, worstBuildings } from '../data/verdicts';
import type { State } from '../state';
import { button, h } from '../ui/dom';

const mostBuildings = 12;
const size: readonly [number, number] = [260, 150];
const halfWidth_m = 0.75;  // of the slab whose points are drawn
const beyond_m = 2;

/** The position of a section: through a point, perpendicular to a direction in plan. */
interface Cut { x: number; y: number; ux: number; uy: number }

/** Through the middle of the building, across its longest edge. */
function cutOf(edges: readonly Line[]): Cut | null {
  const length = (line: Line): number => Math.hypot(line.end![0] - line.start![0], line.end![1] - line.start![1]);
  const longest = [...edges].sort((a, b) => length(b) - length(a))[0];
  if (!longest || !(length(longest) > 0)) return null;
  const range = (axis: 0 | 1): number => {
    const values = edges.flatMap((l) => [l.start![axis], l.end![axis]]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  };
  return { x: range(0), y: range(1), ux: (longest.end![0] - longest.start![0]) / length(longest), uy: (longest.end![1] - longest.start![1]) / length(longest) };
}

/** The points where the edges meet the section, from one side to the other: the outline of the
 * roof. */
function profile(edges: readonly Line[], cut: Cut): [t: number, z: number][] {
  const found: [number, number][] = [];
  for (const { start, end } of edges) {
    const along = (x: readonly number[]): number => (x[0]! - cut.x) * cut.ux + (x[1]! - cut.y) * cut.uy;
    const across = (x: readonly number[]): number => (x[1]! - cut.y) * cut.ux - (x[0]! - cut.x) * cut.uy;
    const [a, b] = [along(start!), along(end!)];
    if (a === b || a * b > 0) continue;
    const share = a / (a - b);
    found.push([across(start!) + share * (across(end!) - across(start!)), start![2] + share * (end![2] - start![2])]);
  }
  return found.sort((a, b) => a[0] - b[0]);
}

function pointsIn(points: Points, positions: Uint16Array, cut: Cut, low: number, high: number): [t: number, z: number][] {
  const found: [number, number][] = [];
  for (let i = 0; i < positions.length / 3; ++i) {
    const x = points.low[0] + positions[3 * i]! * points.step[0] - cut.x;
    const y = points.low[1] + positions[3 * i + 1]! * points.step[1] - cut.y;
    const t = y * cut.ux - x * cut.uy;
    if (Math.abs(x * cut.ux + y * cut.uy) > halfWidth_m || t < low || t > high) continue;
    found.push([t, points.low[2] + positions[3 * i + 2]! * points.step[2]]);
  }
  return found;
}

function section(building: Building, edges: readonly Line[], points: Points, positions: Uint16Array): HTMLCanvasElement | null {
  const cut = cutOf(edges);
  if (!cut) return null;
  const roof = profile(edges, cut);
  if (roof.length < 2) return null;
  const [low, high] = [roof[0]![0] - beyond_m, roof[roof.length - 1]![0] + beyond_m];
  const near = pointsIn(points, positions, cut, low, high);
  const heights = [...roof, ...near].map(([, z]) => z).sort((a, b) => a - b);
  const [bottom, top] = [heights[0]!, heights[heights.length - 1]!];
  const scale = Math.min(size[0] / (high - low), (size[1] - 24) / Math.max(top - bottom, 1));
  const toCanvas = (t: number, z: number): [number, number] => [size[0] / 2 + (t - (low + high) / 2) * scale, size[1] - 16 - (z - bottom) * scale];
  const element = h('canvas', { width: 2 * size[0], height: 2 * size[1], 'aria-label': `Section of building ${building.id}`, role: 'img' });
  const g = element.getContext('2d')!;
  g.scale(2, 2);
  g.fillStyle = '#555';
  for (const [t, z] of near) {
    const [x, y] = toCanvas(t, z);
    g.fillRect(x - 1, y - 1, 2, 2);
  }
  g.strokeStyle = selectionColour;
  g.lineWidth = 1.5;
  g.beginPath();
  roof.forEach(([t, z], i) => (i === 0 ? g.moveTo(...toCanvas(t, z)) : g.lineTo(...toCanvas(t, z))));
  g.stroke();
  g.fillStyle = '#666';
  g.fillRect(4, size[1] - 6, 2 * scale, 2);
  g.font = '9px sans-serif';
  g.fillText('2 m', 6 + 2 * scale, size[1] - 3);
  return element;
}

/** Empty if no building is wrong. */
export function buildingSections(state: State): HTMLElement[] {
  const { buildings = [], lines } = state.method;
  const { points } = state.patch;
  const worst = worstBuildings(buildings).slice(0, mostBuildings);
  if (worst.length === 0) return [];
  const positions = points ? uint16(points.positions) : null;
  return [
    h('h3', {}, `The ${worst.length === 1 ? 'worst building' : `${worst.length} worst buildings`}`),
    h('div', { id: 'building-sections' }, ...worst.map((building, i) => {
      const edges = lines.filter((l) => l.building === building.id && l.start && l.end);
      const index = lines.findIndex((l) => l.building === building.id);
      return h('figure', { class: 'building-section' },
        h('figcaption', {}, `${i + 1}. `, button(building.id, () => state.set({ line: index < 0 ? null : index }), { class: 'plain', title: 'select its first line' }), `: ${building.verdict}. ${reasonOf(building)}`),
        points && positions ? section(building, edges, points, positions) : null);
    })),
    h('p', { class: 'caption' }, 'Sections through the middle, across the longest edge: the model as a line, LIDAR points within 0.75 m as dots.'),
  ];
}

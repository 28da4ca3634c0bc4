// SPDX-License-Identifier: BSD-3-Clause
// Sections across edges: points, planes and the edge.
import { isDark } from '../data/colours';
import { h } from '../ui/dom';
import { kindColour } from './kind_colours';
import type { EdgesReport, SectionRow } from './schema';

const size: readonly [number, number] = [300, 180];

/** Draws the same scale in both directions. */
function drawing(section: SectionRow): HTMLCanvasElement {
  const element = h('canvas', { width: 2 * size[0], height: 2 * size[1], role: 'img', 'aria-label': `Section across ${section.kind} ${section.id}` });
  const g = element.getContext('2d')!;
  const ts = section.points.map(([t]) => t).concat(0);
  const zs = section.points.map(([, z]) => z).concat(section.z);
  const [low, high, bottom, top] = [Math.min(...ts), Math.max(...ts), Math.min(...zs), Math.max(...zs)];
  const scale = Math.min((size[0] - 16) / Math.max(high - low, 1), (size[1] - 32) / Math.max(top - bottom, 1));
  const at = (t: number, z: number): [number, number] => [size[0] / 2 + (t - (low + high) / 2) * scale, size[1] - 22 - (z - bottom) * scale];
  g.scale(2, 2);
  g.fillStyle = isDark() ? '#b8bcc2' : '#555';
  for (const [t, z] of section.points) {
    const [x, y] = at(t, z);
    g.fillRect(x - 1, y - 1, 2, 2);
  }
  g.strokeStyle = isDark() ? '#e3e5e8' : '#23262b';
  g.lineWidth = 1;
  g.beginPath();
  for (const [t0, z0, t1, z1] of section.planes) {
    g.moveTo(...at(t0, z0));
    g.lineTo(...at(t1, z1));
  }
  g.stroke();
  g.fillStyle = kindColour(section.kind);
  g.beginPath();
  g.arc(...at(0, section.z), 4, 0, 2 * Math.PI);
  g.fill();
  g.fillStyle = isDark() ? '#b8bcc2' : '#666';
  g.fillRect(4, size[1] - 6, 2 * scale, 2);
  g.font = '9px sans-serif';
  g.fillText('2 m', 6 + 2 * scale, size[1] - 3);
  return element;
}

function captionOf({ kind, id, length_m, support, sigma_m, moved_out_m }: SectionRow): string {
  const moved = moved_out_m > 0 ? `, moved out by ${moved_out_m.toFixed(3)} m` : '';
  return `${kind} ${id}: ${length_m.toFixed(1)} m, sigma ${sigma_m.toFixed(3)} m, ${Math.round(100 * support)} % supported${moved}`;
}

export function sectionsOf(report: EdgesReport, onPoint: (id: string | null) => void): HTMLElement | null {
  if (report.sections.length === 0) return null;
  return h('section', { id: 'sections' }, h('h2', {}, 'Sections'),
    h('div', { class: 'sections' }, ...report.sections.map((section) => h('figure', {
      tabindex: 0,
      onpointerenter: () => onPoint(section.id),
      onpointerleave: () => onPoint(null),
      onfocusin: () => onPoint(section.id),
      onfocusout: () => onPoint(null),
    }, drawing(section), h('figcaption', {}, captionOf(section))))),
    h('p', { class: 'caption' }, `Across the middle of the longest edges of each kind, seen along the edge: points within ${report.half_width_m} m as dots, roof planes as lines, the edge as a disc. Heights are not exaggerated. Point at a section to mark its edge in the plan.`));
}

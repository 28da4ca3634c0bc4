// SPDX-License-Identifier: BSD-3-Clause
// The frame of a drawing in plan: its extent around the lines, its scale and a scale bar.
import type { Line } from '../data/schema';
import { h } from '../ui/dom';
import { roundLength } from '../ui/round_length';
import { svg } from '../ui/svg';

interface Box { left: number; bottom: number; width: number; height: number }

/** The box around the lines, except the few that lie far from all others. */
function boxOf(lines: readonly Line[]): Box {
  const range = (axis: 0 | 1): [number, number] => {
    const values = lines.flatMap((l) => [l.start![axis], l.end![axis]]).sort((a, b) => a - b);
    const at = (share: number): number => values[Math.round(share * (values.length - 1))]!;
    const [low, high] = [at(0.01), at(0.99)];
    const slack = 0.5 * (high - low) + 1;
    return [Math.max(values[0]!, low - slack), Math.min(values[values.length - 1]!, high + slack)];
  };
  const [x, y] = [range(0), range(1)];
  const margin = 0.03 * Math.max(x[1] - x[0], y[1] - y[0], 1);
  return { left: x[0] - margin, bottom: y[0] - margin, width: x[1] - x[0] + 2 * margin, height: y[1] - y[0] + 2 * margin };
}

/** Lines with both ends, each with its index. */
export const drawnLines = (lines: readonly Line[]): { line: Line; index: number }[] =>
  lines.map((line, index) => ({ line, index })).filter(({ line }) => line.start && line.end);

export interface PlanFrame {
  drawing: SVGElement;
  /** The contents of the drawing are added here. */
  content: SVGElement;
  at: (x: readonly number[]) => [number, number];
}

/** A drawing with room for the lines, which must have both ends. */
export function planFrame(lines: readonly Line[], label: string): PlanFrame {
  const box = boxOf(lines);
  const width = 640;
  const scale = width / box.width;
  const height = Math.min(760, Math.max(200, box.height * scale));
  const drawing = svg('svg', { viewBox: `0 0 ${width} ${height + 34}`, role: 'img', 'aria-label': label });
  const content = svg('g', {});
  drawing.append(svg('rect', { x: 0.5, y: 0.5, width: width - 1, height: height - 1, class: 'frame' }), content, scaleBar(scale, box.width, height));
  return { drawing, content, at: (x) => [(x[0]! - box.left) * scale, height - (x[1]! - box.bottom) * scale] };
}

function scaleBar(scale: number, width_m: number, y: number): SVGElement {
  const length_m = roundLength(0.25 * width_m);
  return svg('g', { class: 'scale-bar' }, svg('path', { d: `M 1 ${y + 10} v 6 h ${length_m * scale} v -6`, fill: 'none' }),
    svg('text', { x: length_m * scale + 8, y: y + 18 }, `${length_m} m`));
}

export function swatch(colour: string, text: string, isDashed = false): HTMLElement {
  const mark = h('span', { class: isDashed ? 'swatch dashed' : 'swatch', 'aria-hidden': 'true' });
  if (isDashed) mark.style.borderColor = colour;
  else mark.style.background = colour;
  return h('span', { class: 'legend-item' }, mark, text);
}

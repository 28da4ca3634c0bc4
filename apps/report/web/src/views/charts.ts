// SPDX-License-Identifier: BSD-3-Clause
import uPlot from 'uplot';
import { classColour, isDark, okabeIto } from '../data/colours';
import type { Line, Method } from '../data/schema';
import { ascending, chiSquare1, median, normalQuantile } from '../data/statistics';
import { h } from '../ui/dom';
import { fixed, words } from '../ui/format';

const kMinDistance_m = 1e-4; // on logarithmic axes, smaller distances are drawn at this value

type Data = uPlot.AlignedData;
type Series = uPlot.Series;

interface Chart {
  id: string;
  title: string;
  caption: string;
  x: { label: string; log?: boolean };
  y: { label: string; log?: boolean; range?: [number, number] };
  series: Series[];
  data: Data;
}

const ink = (): string => (isDark() ? '#d7dade' : '#23262b');
const grid = (): string => (isDark() ? '#33373d' : '#e4e6e9');
const reference = (): string => (isDark() ? '#9aa0a8' : '#6b7178');

const evaluated = (lines: readonly Line[]): (Line & { mean_distance_m: number; signed_mean_m: number })[] =>
  lines.filter((l): l is Line & { mean_distance_m: number; signed_mean_m: number } => l.mean_distance_m !== null && l.signed_mean_m !== null);

const classesOf = (lines: readonly Line[]): string[] => [...new Set(lines.map((l) => l.class))].sort().reverse();

/** Dashes distinguish the classes without colour. */
const dashOf = (lineClass: string): number[] => (lineClass === 'aligned' ? [6, 4] : []);

function curve(label: string, stroke: string, dash: number[] = [], width = 2): Series {
  return { label, stroke, dash, width, points: { show: false }, spanGaps: true };
}

/** A series of circles, or of crosses for aligned lines. */
function cloud(lineClass: string): Series {
  const colour = classColour(lineClass);
  const isAligned = lineClass === 'aligned';
  return { label: words(lineClass), stroke: colour, width: 0, paths: () => null,
    points: { show: true, size: isAligned ? 7 : 5, width: 1.2, stroke: colour, fill: isAligned ? 'transparent' : colour } };
}

/** Merges several sets of points over the union of their x values. */
function join(sets: readonly { x: readonly number[]; y: readonly (number | null)[] }[]): Data {
  return uPlot.join(sets.map((s) => {
    const order = s.x.map((_, i) => i).sort((a, b) => s.x[a]! - s.x[b]!);
    // uPlot.join needs distinct x values within a set
    const x: number[] = [];
    for (const i of order) x.push(x.length > 0 && s.x[i]! <= x[x.length - 1]! ? x[x.length - 1]! * (1 + 1e-12) + 1e-15 : s.x[i]!);
    return [x, order.map((i) => s.y[i] ?? null)] as unknown as Data;
  }));
}

const logSpaced = (low: number, high: number, n: number): number[] =>
  Array.from({ length: n }, (_, i) => low * (high / low) ** (i / (n - 1)));

function histogram(lines: readonly Line[]): Chart {
  const edges = logSpaced(1e-3, 1e2, 31);
  const classes = classesOf(lines);
  const counts = classes.map((c) => {
    const n = new Array<number>(edges.length).fill(0);
    for (const l of evaluated(lines)) {
      if (l.class !== c) continue;
      let bin = 0;
      while (bin < edges.length - 2 && l.mean_distance_m >= edges[bin + 1]!) ++bin;
      n[bin]! += 1;
    }
    return n;
  });
  const stepped = uPlot.paths.stepped?.({ align: 1 });
  return { id: 'histogram', title: 'Histogram of distances', caption: 'Average orthogonal distance of each evaluated line; logarithmic bins, the first and last open.',
    x: { label: 'distance, m', log: true }, y: { label: 'lines' },
    series: classes.map((c) => ({ ...curve(words(c), classColour(c), dashOf(c)), fill: classColour(c) + '30', ...(stepped ? { paths: stepped } : {}) })),
    data: [edges, ...counts] };
}

function cumulative(lines: readonly Line[]): Chart {
  const classes = classesOf(lines);
  const sets = [...classes.map((c) => lines.filter((l) => l.class === c)), lines].map((members) => {
    const x = ascending(evaluated(members).map((l) => Math.max(kMinDistance_m, l.mean_distance_m)));
    return { x, y: x.map((_, i) => (100 * (i + 1)) / x.length) };
  });
  return { id: 'cumulative', title: 'Cumulative distances', caption: 'Share of the evaluated lines of each class within a distance.',
    x: { label: 'distance, m', log: true }, y: { label: '% of lines', range: [0, 100] },
    series: [...classes.map((c) => curve(words(c), classColour(c), dashOf(c))), curve('total', ink(), [2, 3])], data: join(sets) };
}

function quantiles(lines: readonly Line[]): Chart {
  const values = ascending(evaluated(lines).map((l) => l.signed_mean_m));
  const centre = median(values);
  const spread = 1.4826 * median(values.map((v) => Math.abs(v - centre)));
  const x = values.map((_, i) => normalQuantile((i + 0.5) / values.length));
  const limit = Math.max(6 * spread, 0.01);
  const beyond = values.filter((v) => Math.abs(v - centre) > limit).length;
  return { id: 'qq', title: 'Q-Q plot of signed distances', caption: `Against a normal distribution with median ${fixed(centre, 3)} m and NMAD ${fixed(spread, 3)} m (line). `
    + (beyond > 0 ? `${beyond} lines beyond 6 NMAD are drawn at the border.` : 'No line is beyond 6 NMAD.'),
  x: { label: 'normal quantile' }, y: { label: 'signed distance, m', range: [centre - 1.05 * limit, centre + 1.05 * limit] },
  series: [{ label: 'lines', stroke: ink(), width: 0, paths: () => null, points: { show: true, size: 5, stroke: ink(), fill: 'transparent' } }, curve('normal', reference(), [6, 4], 1.5)],
  data: [x, values.map((v) => Math.min(centre + limit, Math.max(centre - limit, v))), x.map((q) => centre + spread * q)] };
}

function againstAngle(lines: readonly Line[]): Chart {
  const used = evaluated(lines).filter((l) => l.epipolar_angle_deg !== null);
  const angle = (l: Line): number => Math.max(0.02, l.epipolar_angle_deg ?? 0);
  const sine = (deg: number): number => Math.sin((deg * Math.PI) / 180);
  const k = median(used.filter((l) => l.class !== 'aligned').map((l) => l.mean_distance_m * sine(angle(l))));
  const classes = classesOf(used);
  const sets = classes.map((c) => {
    const members = used.filter((l) => l.class === c);
    return { x: members.map(angle), y: members.map((l) => Math.max(kMinDistance_m, l.mean_distance_m)) };
  });
  const x = logSpaced(0.02, 90, 80);
  return { id: 'angle', title: 'Distance against epipolar angle', caption: Number.isFinite(k)
    ? `Curve: ${fixed(k, 4)} m / sin(angle), as predicted for the intersection of projection planes; the factor is the median of distance · sin(angle) over not_aligned lines.` : '',
  x: { label: 'angle to the epipolar line, °', log: true }, y: { label: 'distance, m', log: true },
  series: [...classes.map(cloud), curve('1/sin', ink(), [2, 3], 1.5)],
  data: join([...sets, { x, y: x.map((a) => (Number.isFinite(k) ? k / sine(a) : null)) }]) };
}

function againstTruth(lines: readonly Line[]): Chart | null {
  const used = evaluated(lines).filter((l) => typeof l.true_error_m === 'number');
  if (used.length === 0) return null;
  const classes = classesOf(used);
  const sets = classes.map((c) => {
    const members = used.filter((l) => l.class === c);
    return { x: members.map((l) => Math.max(kMinDistance_m, l.mean_distance_m)), y: members.map((l) => Math.max(kMinDistance_m, l.true_error_m ?? 0)) };
  });
  const diagonal = logSpaced(1e-3, 1e1, 20);
  return { id: 'truth', title: 'True error against LIDAR distance', caption: `${used.length} lines that lie on a true line in both images. Above the diagonal: shifts that the distance from a plane cannot show.`,
    x: { label: 'distance from LIDAR planes, m', log: true }, y: { label: 'true error, m', log: true },
    series: [...classes.map(cloud), curve('equal', reference(), [6, 4], 1.5)], data: join([...sets, { x: diagonal, y: diagonal }]) };
}

function normalised(lines: readonly Line[]): Chart | null {
  const z2 = ascending(evaluated(lines).filter((l) => l.z !== null).map((l) => Math.max(1e-4, (l.z ?? 0) ** 2)));
  if (z2.length === 0) return null;
  const x = logSpaced(1e-4, Math.max(20, z2[z2.length - 1]!), 120);
  return { id: 'chi-square', title: 'Normalised errors against chi-square', caption: 'Cumulative share of lines by normalised squared error z², and chi-square with one degree of freedom. A curve to the right of it means that sigmas are too small.',
    x: { label: 'z²', log: true }, y: { label: '% of lines', range: [0, 100] },
    series: [curve('lines', okabeIto.blue), curve('chi-square', ink(), [6, 4], 1.5)],
    data: join([{ x: z2, y: z2.map((_, i) => (100 * (i + 1)) / z2.length) }, { x, y: x.map((v) => 100 * chiSquare1(v)) }]) };
}

function axis(label: string, log: boolean | undefined): uPlot.Axis {
  return { label, stroke: ink(), grid: { stroke: grid(), width: 1 }, ticks: { stroke: grid(), width: 1 }, labelSize: 22, font: '12px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif',
    ...(log ? { values: (_: uPlot, splits: (number | null)[]) => splits.map((v) => (v === null || Math.abs(Math.log10(v) % 1) > 1e-6 ? '' : String(Number(v.toPrecision(1))))) } : {}) };
}

function draw(chart: Chart, parent: HTMLElement): uPlot {
  const options: uPlot.Options = {
    width: Math.max(280, parent.clientWidth), height: 260,
    cursor: { drag: { x: true, y: true } }, legend: { live: false },
    scales: { x: { time: false, ...(chart.x.log ? { distr: 3 as const } : {}) }, y: { ...(chart.y.log ? { distr: 3 as const } : {}), ...(chart.y.range ? { range: chart.y.range } : {}) } },
    axes: [axis(chart.x.label, chart.x.log), { ...axis(chart.y.label, chart.y.log), size: 54 }],
    series: [{ label: chart.x.label }, ...chart.series],
  };
  return new uPlot(options, chart.data, parent);
}

/** The charts of a method; redrawn when the method, theme or width changes. */
export class Charts {
  readonly element = h('section', { id: 'charts' });
  private plots: uPlot[] = [];
  private charts: Chart[] = [];
  private boxes: HTMLElement[] = [];

  constructor() {
    new ResizeObserver(() => {
      this.plots.forEach((plot, i) => {
        const width = Math.max(280, this.boxes[i]!.clientWidth);
        if (Math.abs(width - plot.width) > 4) plot.setSize({ width, height: 260 });
      });
    }).observe(this.element);
  }

  show(method: Method): void {
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    const lines = method.lines;
    if (evaluated(lines).length === 0) {
      this.element.replaceChildren(h('h3', {}, 'Charts'), h('p', { class: 'caption' }, 'No line was evaluated.'));
      return;
    }
    this.charts = [histogram(lines), cumulative(lines), quantiles(lines),
      ...(lines.some((l) => l.epipolar_angle_deg !== null) ? [againstAngle(lines)] : []), againstTruth(lines), normalised(lines)].filter((c): c is Chart => c !== null);
    this.boxes = this.charts.map(() => h('div', { class: 'plot' }));
    this.element.replaceChildren(h('h3', {}, `Charts: ${method.name}`),
      h('div', { class: 'charts' }, ...this.charts.map((c, i) => h('figure', { id: `chart-${c.id}` }, h('figcaption', {}, h('b', {}, c.title)), this.boxes[i]!, h('p', { class: 'caption' }, c.caption)))));
    this.plots = this.charts.map((c, i) => draw(c, this.boxes[i]!));
  }
}

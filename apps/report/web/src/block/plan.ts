// SPDX-License-Identifier: BSD-3-Clause
// The plan of a block: where it is good and where it is bad.
import { checkbox, choice, h, replace } from '../ui/dom';
import { percent } from '../ui/format';
import { lineLegend, shadeLegend } from './legend';
import { Sheet } from './map';
import type { BlockReport, Box, PatchRow } from './schema';
import { figuresOf, type Figure } from './shades';
import { Squares } from './squares';

const grossFrom_m = 0.3;
const leastForLines = 40; // units of the drawing: on smaller squares, lines hide the shades
type LinesShown = 'none' | 'gross' | 'all';

function boxOf(report: BlockReport): Box {
  const all = report.patches.map((p) => p.core);
  const of = (k: number, choose: (...values: number[]) => number): number => all.reduce((v, box) => choose(v, box[k]!), all[0]![k]!);
  return [of(0, Math.min), of(1, Math.min), of(2, Math.max), of(3, Math.max)];
}

export class BlockPlan {
  readonly element = h('section', { id: 'plan' });
  private readonly sheet: Sheet;
  private readonly squares: Squares;
  private readonly legend = h('div');
  private readonly lineNote = h('p', { class: 'caption', id: 'lines-shown', role: 'status' });
  private readonly lineColours = h('div');
  private readonly info = h('div', { id: 'patch-info' });
  private readonly controls = h('div', { class: 'controls' });
  private figure: Figure;
  private lines: LinesShown;
  private hasRelief = false;

  constructor(private readonly report: BlockReport, private method: number) {
    this.figure = this.figures()[0]!;
    this.sheet = new Sheet(boxOf(report), 'Plan of the patches; move with the arrow keys, open a page with Enter', 860, 820);
    this.lines = this.report.patch_size_m * this.sheet.scale < leastForLines ? 'none' : 'gross';
    this.squares = new Squares(this.sheet, report.patches, (i) => this.showInfo(i));
    replace(this.element, h('h2', {}, 'Plan of the patches'), this.controls,
      h('div', { class: 'map' }, h('div', {}, this.sheet.element, this.sheet.foot(), this.lineColours, this.lineNote), h('div', { class: 'beside' }, this.legend, this.info)));
    this.sheet.element.addEventListener('pointerleave', () => this.showInfo(null));
    this.show(this.method);
  }

  private figures(): Figure[] {
    const figures = figuresOf(this.report.patches.filter((p) => p.reason === '').map((p) => p.figures[this.method]!));
    return figures.length > 0 ? figures : figuresOf([{ n_lines: 0, n_evaluated: 0, rms_m: null, median_m: null, max_m: null, n_reference_lines: 0, n_reference_found: 0 }]);
  }

  show(method: number): void {
    this.method = method;
    const figures = this.figures();
    this.figure = figures.find((f) => f.key === this.figure.key) ?? figures[0]!;
    replace(this.controls,
      choice('Colour of the squares', figures.map((f) => ({ value: f.key, text: f.name })), this.figure.key, (key) => { this.figure = figures.find((f) => f.key === key)!; this.draw(); }),
      choice<LinesShown>('Lines', [{ value: 'none', text: 'none' }, { value: 'gross', text: `above ${grossFrom_m.toFixed(2)} m` }, { value: 'all', text: 'all' }], this.lines, (lines) => { this.lines = lines; this.draw(); }),
      this.report.points ? checkbox('LIDAR heights', this.hasRelief, (on) => { this.hasRelief = on; this.draw(); }) : null);
    this.draw();
  }

  /** Redraws everything; also called after a change of theme. */
  draw(): void {
    const { lines } = this.report.methods[this.method]!;
    const from_m = this.lines === 'all' ? null : grossFrom_m;
    this.squares.show(this.figure, this.method, this.hasRelief || this.lines === 'all');
    this.sheet.drawRelief(this.hasRelief ? this.report.points : null);
    const isDense = this.report.patch_size_m * this.sheet.scale < leastForLines;
    const weight = (this.lines === 'gross' ? 2.6 : 1.6) * (isDense ? 0.45 : 1);
    this.sheet.drawLines(this.lines === 'none' ? null : lines, from_m, weight);
    replace(this.legend, shadeLegend(this.figure, this.report.patches, this.method));
    replace(this.lineColours, this.lines === 'none' ? null : lineLegend(from_m));
    this.lineNote.textContent = this.noteOf();
    this.showInfo(null);
  }

  private noteOf(): string {
    const count = (n: number): string => n.toLocaleString('en');
    const { lines } = this.report.methods[this.method]!;
    const { points } = this.report;
    const thinned = lines.n_shown < lines.n_all ? `${count(lines.n_shown)} of ${count(lines.n_all)} lines are shown, including those farthest from the LIDAR planes.` : `All ${count(lines.n_all)} lines are shown.`;
    const relief = this.hasRelief && points ? ` ${count(points.n_shown)} of ${count(points.n_all)} LIDAR points, grey from ${points.low_m} m (dark) to ${points.high_m} m (light).` : '';
    return (this.lines === 'none' ? '' : `Lines: distance from the LIDAR planes${this.lines === 'gross' ? `, those above ${grossFrom_m.toFixed(2)} m` : ''}. ${thinned}`) + relief;
  }

  private showInfo(i: number | null): void {
    const patch = i === null ? null : this.report.patches[i]!;
    replace(this.info, patch ? this.facts(patch) : h('p', { class: 'caption' }, 'Point at a square, or move to it with Tab and the arrow keys, for its figures; click or press Enter to open its page.'));
  }

  private facts(patch: PatchRow): HTMLElement {
    const figures = patch.figures[this.method]!;
    const rows: [string, string][] = patch.reason !== '' ? [['failed', patch.reason]]
      : this.figures().map((f) => [f.name, `${f.text(f.value(figures))} ${f.value(figures) === null ? '' : f.unit}`]);
    if (patch.reason === '') rows.push(['lines judged', `${figures.n_evaluated} of ${figures.n_lines}`]);
    if (figures.n_reference_lines > 0) rows.push(['true lines found', `${figures.n_reference_found} of ${figures.n_reference_lines} (${percent(figures.n_reference_found / figures.n_reference_lines)} %)`]);
    rows.push(['images', String(patch.n_images)]);
    return h('div', {}, h('h3', {}, h('a', { href: `pages/${patch.id}.html` }, `Patch ${patch.id}`)),
      h('dl', {}, ...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)])));
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// What a client reads first: the verdict, the key figure, the product and its reference, the worst
// lines, what to fix, and a plan of the lines.
import { halfSentence, headline, isOfFiles, ofPlace, placeSentence, productRows } from '../data/product';
import type { Report, Summary } from '../data/schema';
import type { State } from '../state';
import { h, replace } from '../ui/dom';
import { interval, metres, percent } from '../ui/format';
import { completeness } from './completeness';
import { decoys } from './decoys';
import { comparedFiles, lineFiles } from './line_files';
import { Plan } from './plan';
import { toFix } from './to_fix';
import { verdict } from './verdict';
import { WorstLines } from './worst_lines';

export const titleOf = (report: Report): string =>
  report.run.page?.title || (isOfFiles(report) ? 'Accuracy of 3D lines against LIDAR' : 'Line reconstruction report');

/** RMS over several patches, from the sums of their squares and counts. */
function pooled(rows: readonly Summary[]): { rms_m: number | null; n: number; lines: number } {
  let squares = 0;
  let n = 0;
  let lines = 0;
  for (const row of rows) {
    lines += row.n_lines;
    if (row.rms_m === null) continue;
    squares += row.rms_m ** 2 * row.n_evaluated;
    n += row.n_evaluated;
  }
  return { rms_m: n > 0 ? Math.sqrt(squares / n) : null, n, lines };
}

function keyFigure(report: Report): HTMLElement | null {
  const classes = productRows(report);
  const rows = classes.map(headline);
  const all = pooled(rows);
  if (all.rms_m === null) return null;
  const place = pooled(classes.map(ofPlace).filter((figures) => figures !== null));
  const one = rows.length === 1 ? rows[0]! : null;
  const [leading] = comparedFiles(report);
  const about = [
    one?.ci95_m ? `95 % interval ${interval(one.ci95_m)} m` : null,
    one ? `median ${metres(one.median_m)} m` : `medians ${rows.map((r) => metres(r.median_m)).join(', ')} m`,
    rows.length > 1 ? `over ${rows.length} patches` : null,
    `${all.n} of ${all.lines} lines judged (${percent(all.lines > 0 ? all.n / all.lines : null)} %)`,
    one ? halfSentence(one) : null,
    place.n > 0 ? `${placeSentence(place)}; all together ${metres(pooled(classes).rms_m)} m` : null,
  ].filter((text): text is string => text !== null);
  return h('div', { id: 'key-figure' }, h('span', { class: 'value' }, `${metres(all.rms_m)} m`),
    h('div', {}, h('strong', {}, `RMS distance of the lines${leading ? ` of ${leading}` : ''} from LIDAR planes`), h('p', { class: 'caption' }, `${about.join('; ')}.`), parts(rows)));
}

/** The horizontal and vertical errors of ridges, if there is only one patch and it has ridges. */
function parts(rows: readonly Summary[]): HTMLElement | null {
  const [row] = rows;
  if (rows.length !== 1 || !row || !row.n_parts) return null;
  return h('p', { class: 'caption', id: 'parts' }, `At ${row.n_parts} ridges and hips: RMSE ${metres(row.rmse_horizontal_m)} m across in plan, ${metres(row.rmse_vertical_m)} m in height (mean ${metres(row.mean_vertical_m)} m).`);
}

function facts(report: Report): HTMLElement {
  const { run } = report;
  const files = (role: string): string => (run.inputs ?? []).filter((i) => i.role === role).map((i) => `${i.path} (${i.sha256.slice(0, 12)})`).join(', ');
  const methods = [...new Set(productRows(report).map((r) => r.method))].join(', ');
  const images = [...new Set((run.inputs ?? []).filter((i) => i.role === 'image').map((i) => i.path))].length;
  const warnings = run.warnings?.length ?? 0;
  const rows: [string, Node | string | undefined][] = [
    ['Project', run.page?.project],
    [comparedFiles(report).length > 0 ? 'Products' : 'Product', isOfFiles(report) ? files('lines') : `3D lines by method ${methods}${images > 0 ? ` from ${(run.inputs ?? []).filter((i) => i.role === 'image').length} images` : ''}`],
    ['Reference', files('cloud') || files('lidar') || 'none'],
    ['CRS', [...new Set(report.patches.map((p) => p.crs))].join('; ')],
    ['Operator', run.page?.operator],
    ['Date', run.page?.date],
    ['Made with', `ridgeline ${run.versions?.['ridgeline'] ?? ''}`],
    ['Warnings', warnings > 0 ? h('a', { href: '#provenance' }, `${warnings}, below`) : undefined],
  ];
  return h('dl', { id: 'facts' }, ...rows.flatMap(([name, value]) => (value ? [h('dt', {}, name), h('dd', {}, value)] : [])));
}

export class Acceptance {
  readonly element: HTMLElement;
  private readonly plan: Plan;
  private readonly worst: WorstLines;
  private readonly completeness = h('div', { id: 'completeness' });
  private readonly decoys = h('div', { id: 'decoys' });
  private readonly toFix = h('div', { id: 'to-fix' });

  constructor(private readonly state: State) {
    const { report } = state;
    this.plan = new Plan(state);
    this.worst = new WorstLines(state);
    this.element = h('section', { id: 'acceptance' }, verdict(report),
      h('div', { class: 'columns' }, h('div', { class: 'summary' }, keyFigure(report), lineFiles(state), facts(report), this.completeness, this.decoys), this.worst.element, this.toFix, this.plan.element));
    this.show();
    state.onChange((now, before) => {
      if (now.patch !== before.patch || now.method !== before.method) this.show();
      this.plan.select(now.line);
    });
  }

  show(): void {
    this.plan.show(this.state.patch, this.state.method);
    this.worst.show(this.state.patch, this.state.method);
    replace(this.completeness, completeness(this.state.method));
    replace(this.decoys, decoys(this.state.method));
    replace(this.toFix, ...toFix(this.state, this.state.method));
  }
}

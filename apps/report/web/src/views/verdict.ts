// SPDX-License-Identifier: BSD-3-Clause
// The verdict on the acceptance limits, in one sentence.
import type { GateResult, Report } from '../data/schema';
import { h } from '../ui/dom';
import { fixed } from '../ui/format';

const ofGate = (g: GateResult): string => `${g.rule}${g.value === null ? '' : ` (is ${fixed(g.value, 4)})`}`;

export function verdict(report: Pick<Report, 'gates'>): HTMLElement {
  const { gates } = report;
  if (!gates) {
    return h('p', { id: 'verdict', class: 'verdict none' }, h('strong', {}, 'No acceptance limits were given'), ' (ridgeline report DIR --gates FILE).');
  }
  const failed = gates.gates.filter((g) => g.verdict !== 'passed');
  if (gates.passed) {
    return h('p', { id: 'verdict', class: 'verdict passed' }, h('strong', {}, 'Accepted'), `: all ${gates.gates.length} checks passed.`);
  }
  const shown = failed.slice(0, 3).map(ofGate).join('; ');
  return h('p', { id: 'verdict', class: 'verdict failed' }, h('strong', {}, 'Not accepted'),
    `: ${failed.length} of ${gates.gates.length} checks failed: ${shown}${failed.length > 3 ? '; …' : ''}.`);
}

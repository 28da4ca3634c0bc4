// SPDX-License-Identifier: BSD-3-Clause
import type { Report } from '../data/schema';
import { h, table } from '../ui/dom';

function rowsOf(value: unknown, path: string[] = []): { key: string; value: string }[] {
  if (value !== null && typeof value === 'object' && !Array.isArray(value)) {
    return Object.entries(value).flatMap(([key, v]) => rowsOf(v, [...path, key]));
  }
  return [{ key: path.join('.'), value: Array.isArray(value) ? value.join(', ') : String(value) }];
}

const pairs = (value: unknown, id: string): HTMLElement =>
  table([{ title: 'name', cell: (r) => r.key }, { title: 'value', cell: (r) => r.value }], rowsOf(value), { id });

/** Versions, options and input hashes: everything needed to repeat the run. */
export function provenance(report: Pick<Report, 'run'>): HTMLElement {
  const { run } = report;
  return h('section', { id: 'provenance' }, h('h2', {}, 'Provenance'),
    ...(run.warnings ?? []).map((w) => h('p', { class: 'caption' }, `Warning: ${w}`)),
    h('details', {}, h('summary', {}, 'Input files'),
      table([
        { title: 'role', cell: (i) => i.role },
        { title: 'file', cell: (i) => i.path },
        { title: 'bytes', number: true, cell: (i) => i.bytes.toLocaleString('en') },
        { title: 'SHA-256', cell: (i) => h('code', {}, i.sha256) },
      ], run.inputs ?? [], { id: 'inputs' })),
    h('details', {}, h('summary', {}, `Versions: ridgeline ${run.versions?.['ridgeline'] ?? ''} (${run.versions?.['git_hash'] ?? ''})`), pairs(run.versions ?? {}, 'versions')),
    h('details', {}, h('summary', {}, 'Options'), pairs({ command: run.command ?? '', ...run.options }, 'options')));
}

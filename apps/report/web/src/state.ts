// SPDX-License-Identifier: BSD-3-Clause
import type { Line, Method, Patch, Report } from './data/schema';

export interface Selection {
  patch: number;
  method: number;
  line: number | null; // index in the method's lines
  match: number | null; // index of the match under review
  pair: number; // index in PatchImages.pairs of the pair shown and reviewed
}

type Listener = (now: Selection, before: Selection) => void;

/** The selection, which all parts of the page share. */
export class State {
  private selection: Selection = { patch: 0, method: 0, line: null, match: null, pair: 0 };
  private readonly listeners: Listener[] = [];

  constructor(readonly report: Report) {
    this.selection.method = this.patch.product;
  }

  get now(): Selection {
    return this.selection;
  }
  get patch(): Patch {
    return this.report.patches[this.selection.patch]!;
  }
  get method(): Method {
    return this.patch.methods[this.selection.method]!;
  }
  get line(): Line | null {
    return this.selection.line === null ? null : (this.method.lines[this.selection.line] ?? null);
  }

  onChange(listener: Listener): void {
    this.listeners.push(listener);
  }

  set(change: Partial<Selection>): void {
    const before = this.selection;
    const now = { ...before, ...change };
    if ((Object.keys(now) as (keyof Selection)[]).every((key) => now[key] === before[key])) return;
    this.selection = now;
    for (const listener of this.listeners) listener(now, before);
  }

  choosePatch(patch: number): void {
    const chosen = this.report.patches[patch]!;
    const same = chosen.methods.findIndex((m) => m.name === this.method.name);
    this.set({ patch, method: same >= 0 ? same : chosen.product, line: null, match: null, pair: 0 });
  }

  /** Chooses a method. Its line with the same id, if any, stays selected. */
  chooseMethod(method: number): void {
    const id = this.line?.id;
    const line = id === undefined ? -1 : this.patch.methods[method]!.lines.findIndex((l) => l.id === id);
    this.set({ method, line: line < 0 ? null : line });
  }

  /** Index of the line made from a segment of an image; null if there is none. */
  lineOfSegment(view: number, segment: number): number | null {
    const index = this.method.lines.findIndex((l) => l.observations?.some((s) => s[0] === view && s[1] === segment));
    return index < 0 ? null : index;
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// Matches judged by eye. The browser's storage keeps the state when the page is closed, under a
// hash of the matches and segments, so that another run starts afresh.
import { hash53 } from '../data/decode';
import type { Match, PairOfViews } from '../data/schema';
import type { State } from '../state';
import { sideOf, type PatchImages } from '../views/patch_images';

export type EyeVerdict = 'correct' | 'false' | 'unsure';
type Pair = [number, number];
interface Stored { verdicts: Record<string, EyeVerdict>; added: Pair[] }

const keyOf = (match: { left: number; right: number }): string => `${match.left}-${match.right}`;

function isStored(value: unknown): value is Stored {
  const v = value as Partial<Stored> | null;
  return typeof v === 'object' && v !== null && typeof v.verdicts === 'object' && Array.isArray(v.added);
}

export class Review {
  private stored: Stored = { verdicts: {}, added: [] };
  private storageKey = '';
  private images: PatchImages | null = null;
  private adding: [number | null, number | null] | null = null;
  private readonly listeners: (() => void)[] = [];

  constructor(private readonly state: State) {
    state.onChange((now, before) => {
      if (now.pair !== before.pair && now.patch === before.patch) this.load();
    });
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  show(images: PatchImages | null): void {
    this.images = images;
    this.load();
  }

  /** The pair of images whose matches are judged. */
  get pair(): PairOfViews | null {
    return this.images?.pairs[this.state.now.pair] ?? null;
  }

  /** Resumes the review of the pair where it was left. */
  private load(): void {
    this.adding = null;
    this.stored = { verdicts: {}, added: [] };
    const { images, pair } = this;
    if (!images || !pair) return;
    const segments = [pair.base, pair.search].map((v) => images.images.views[v]!.segments);
    this.storageKey = `ridgeline-review-${hash53([JSON.stringify(pair.matches.map(keyOf)), ...segments])}`;
    try {
      const value: unknown = JSON.parse(localStorage.getItem(this.storageKey) ?? 'null');
      if (isStored(value)) this.stored = value;
    } catch {
      // the browser provides no storage: the review lasts as long as the page
    }
  }

  get matches(): readonly Match[] {
    return this.pair?.matches ?? [];
  }
  get isActive(): boolean {
    return this.state.now.match !== null;
  }
  get isAdding(): boolean {
    return this.adding !== null;
  }
  get nJudged(): number {
    return Object.keys(this.stored.verdicts).length;
  }
  get hasBegun(): boolean {
    for (const _ in this.stored.verdicts) return true;
    return this.stored.added.length > 0;
  }

  current(): Match | null {
    return this.state.now.match === null ? null : (this.matches[this.state.now.match] ?? null);
  }

  eyeVerdict(match: Match): EyeVerdict | null {
    return this.stored.verdicts[keyOf(match)] ?? null;
  }

  /** The verdict of a match: by eye once a review has begun, otherwise by the reference. */
  verdictOf(match: Match): string {
    if (this.hasBegun || this.isActive) return this.eyeVerdict(match) ?? 'unjudged';
    return match.verdict ?? 'unjudged';
  }

  /** Pairs of segments that should have been matched. */
  missed(): readonly Pair[] {
    if (this.hasBegun || this.isActive) return this.stored.added;
    return this.pair?.missed ?? [];
  }

  pending(view: number): number | null {
    const side = this.pair ? sideOf(this.pair, view) : null;
    return side === null ? null : (this.adding?.[side] ?? null);
  }

  start(): void {
    if (this.matches.length > 0) this.go(this.nextUnjudged(-1) ?? 0);
  }

  stop(): void {
    this.adding = null;
    this.state.set({ match: null });
    this.changed();
  }

  step(by: number): void {
    const n = this.matches.length;
    if (n > 0 && this.state.now.match !== null) this.go((this.state.now.match + by + n) % n);
  }

  judge(verdict: EyeVerdict): void {
    const match = this.current();
    if (!match) return;
    this.stored.verdicts[keyOf(match)] = verdict;
    this.save();
    const next = this.nextUnjudged(this.state.now.match ?? -1);
    if (next !== null) this.go(next);
    else this.changed();
  }

  toggleAdding(): void {
    this.adding = this.adding ? null : [null, null];
    this.changed();
  }

  /** Handles a click on a segment (or on none). Returns whether it was meant for a missed match. */
  takesClick(view: number, segment: number | null): boolean {
    if (!this.adding || !this.pair) return false;
    const side = sideOf(this.pair, view);
    if (side === null) return true; // the image is not in the pair
    this.adding[side] = segment;
    const [left, right] = this.adding;
    if (left !== null && right !== null) {
      const isKnown = this.matches.some((m) => m.left === left && m.right === right) || this.stored.added.some((p) => p[0] === left && p[1] === right);
      if (!isKnown) this.stored.added.push([left, right]);
      this.adding = null;
      this.save();
    }
    this.changed();
    return true;
  }

  removeLastAdded(): void {
    this.stored.added.pop();
    this.save();
    this.changed();
  }

  get nAdded(): number {
    return this.stored.added.length;
  }

  /** The numbers of verdicts, counted as `run` does: a left segment with a false match counts as
   * false and not also as missed. */
  counts(): { correct: number; false: number; unsure: number; missed: number } {
    const n = { correct: 0, false: 0, unsure: 0, missed: 0 };
    const isFalse = new Set<number>();
    for (const match of this.matches) {
      const verdict = this.eyeVerdict(match);
      if (verdict) ++n[verdict];
      if (verdict === 'false') isFalse.add(match.left);
    }
    n.missed = this.stored.added.filter(([left]) => !isFalse.has(left)).length;
    return n;
  }

  /** `run` reads reference_matches.csv for the base pair; the file of another pair is named after
   * its images. */
  get fileName(): string {
    const { images, pair } = this;
    return images && pair && this.state.now.pair > 0 ? `reference_matches.${images.nameOfPair(pair, '-')}.csv` : 'reference_matches.csv';
  }

  /** The rows of the file: edges with their segments in both images. Unsure matches are omitted. */
  rows(): (string | number)[][] {
    const ends = ['x1_px', 'y1_px', 'x2_px', 'y2_px'];
    const rows: (string | number)[][] = [['id', 'verdict', ...ends.map((e) => `left_${e}`), ...ends.map((e) => `right_${e}`)]];
    const views = this.pair;
    if (!views) return rows;
    const add = (pair: Pair, verdict: string): void => {
      const inFile = (view: number, id: number): string[] => {
        const corner = this.images?.images.views[view]?.corner_px ?? [0, 0];
        return (this.images?.segment(view, id) ?? []).map((value, k) => (value + corner[k % 2]!).toFixed(3));
      };
      rows.push([`${pair[0]}-${pair[1]}`, verdict, ...inFile(views.base, pair[0]), ...inFile(views.search, pair[1])]);
    };
    for (const match of this.matches) {
      const verdict = this.eyeVerdict(match);
      if (verdict === 'correct' || verdict === 'false') add([match.left, match.right], verdict);
    }
    for (const pair of this.stored.added) add(pair, 'missed');
    return rows;
  }

  private nextUnjudged(from: number): number | null {
    const n = this.matches.length;
    for (let k = 1; k <= n; ++k) {
      const i = (from + k + n) % n;
      if (!this.eyeVerdict(this.matches[i]!)) return i;
    }
    return null;
  }

  private go(match: number): void {
    const m = this.matches[match];
    this.state.set({ match, line: m && this.pair ? this.state.lineOfSegment(this.pair.base, m.left) : null });
    this.changed();
  }

  private save(): void {
    try {
      localStorage.setItem(this.storageKey, JSON.stringify(this.stored));
    } catch {
      // the browser provides no storage
    }
  }

  private changed(): void {
    for (const listener of this.listeners) listener();
  }
}

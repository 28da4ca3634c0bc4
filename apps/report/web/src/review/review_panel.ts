// SPDX-License-Identifier: BSD-3-Clause
import type { State } from '../state';
import { button, h, replace } from '../ui/dom';
import { csv, download } from '../ui/download';
import { fixed, percent } from '../ui/format';
import type { PatchImages } from '../views/patch_images';
import type { Review } from './review';

const share = (part: number, whole: number): string => percent(whole > 0 ? part / whole : null);

export class ReviewPanel {
  readonly element = h('section', { id: 'review' });
  private images: PatchImages | null = null;

  constructor(private readonly state: State, private readonly review: Review) {
    review.onChange(() => this.update());
    state.onChange(() => this.update());
  }

  export(): void {
    download(this.review.fileName, csv(this.review.rows()));
  }

  show(images: PatchImages | null): void {
    this.images = images;
    this.update();
  }

  /** States which of several pairs is judged and what its file can be used for. */
  private aboutPair(): string {
    const { images, review } = this;
    const { pair } = this.state.now;
    if (!images?.areSeveral || !review.pair) return '';
    const name = images.nameOfPair(review.pair);
    if (pair === 0) return ` These are the matches of the base pair, ${name}; select other images above.`;
    return ` These are the matches of ${name}, ${images.wasMatched(pair) ? 'matched by the run' : 'derived from tracks'}. Their file is a reference for a patch that starts with these two images.`;
  }

  update(): void {
    const { review } = this;
    if (review.matches.length === 0 && !this.images?.areSeveral) {
      replace(this.element);
      return;
    }
    const n = review.counts();
    const judged = h('p', { id: 'review-counts', role: 'status' },
      `${review.nJudged} of ${review.matches.length} matches judged: ${n.correct} correct, ${n.false} false, ${n.unsure} unsure; ${n.missed} missed added. `
      + `Correctness ${share(n.correct, n.correct + n.false)} %, completeness ${share(n.correct, n.correct + n.missed)} %, quality ${share(n.correct, n.correct + n.false + n.missed)} %.`);
    replace(this.element, h('h3', {}, 'Check matches by eye'),
      h('p', { class: 'caption' }, 'Judge matches by eye, as the paper did for Table 1. Your progress is kept in this browser; the exported file is the reference_matches of a patch.' + this.aboutPair()),
      h('div', { class: 'controls' },
        review.isActive ? button('Leave review', () => review.stop(), { title: 'r or Escape' }) : button(review.hasBegun ? 'Continue review' : 'Start review', () => review.start(), { id: 'review-start', title: 'r', disabled: review.matches.length === 0 }),
        ...(review.isActive ? this.judging() : []),
        button(`Export ${review.fileName}`, () => this.export(), { id: 'review-export', disabled: !review.hasBegun })),
      review.isActive ? this.currentMatch() : null,
      review.hasBegun || review.isActive ? judged : null);
  }

  private judging(): HTMLElement[] {
    const { review } = this;
    return [
      button('← Previous', () => review.step(-1), { title: 'p' }),
      button('Next →', () => review.step(1), { title: 'n' }),
      button('Correct (c)', () => review.judge('correct'), { class: 'correct' }),
      button('False (f)', () => review.judge('false'), { class: 'false' }),
      button('Unsure (u)', () => review.judge('unsure'), { class: 'unsure' }),
      button(review.isAdding ? 'Click both segments …' : 'Add missed (m)', () => review.toggleAdding(), { 'aria-pressed': String(review.isAdding), id: 'review-add' }),
      ...(review.nAdded > 0 ? [button('Remove last added', () => review.removeLastAdded())] : []),
    ];
  }

  private currentMatch(): HTMLElement {
    const match = this.review.current();
    const at = (this.state.now.match ?? 0) + 1;
    return h('p', { id: 'review-match' }, match
      ? `Match ${at} of ${this.review.matches.length}: segments ${match.left} and ${match.right}${match.score === undefined ? '' : `, score ${fixed(match.score, 3)}, votes ${fixed(match.votes, 1)}`}. Judged: ${this.review.eyeVerdict(match) ?? 'not yet'}.`
      : '');
  }
}

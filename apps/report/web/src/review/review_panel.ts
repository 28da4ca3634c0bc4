// SPDX-License-Identifier: BSD-3-Clause
import type { State } from '../state';
import { button, h, replace } from '../ui/dom';
import { csv, download } from '../ui/download';
import { fixed, percent } from '../ui/format';
import type { Review } from './review';

const share = (part: number, whole: number): string => percent(whole > 0 ? part / whole : null);

export class ReviewPanel {
  readonly element = h('section', { id: 'review' });

  constructor(private readonly state: State, private readonly review: Review) {
    review.onChange(() => this.update());
    state.onChange(() => this.update());
  }

  export(): void {
    download('reference_matches.csv', csv(this.review.rows()));
  }

  update(): void {
    const { review } = this;
    if (review.matches.length === 0) {
      replace(this.element);
      return;
    }
    const n = review.counts();
    const judged = h('p', { id: 'review-counts', role: 'status' },
      `${review.nJudged} of ${review.matches.length} matches judged: ${n.correct} correct, ${n.false} false, ${n.unsure} unsure; ${n.missed} missed added. `
      + `Correctness ${share(n.correct, n.correct + n.false)} %, completeness ${share(n.correct, n.correct + n.missed)} %, quality ${share(n.correct, n.correct + n.false + n.missed)} %.`);
    replace(this.element, h('h3', {}, 'Checking matches by eye'),
      h('p', { class: 'caption' }, 'As the matches of the paper’s Table 1 were judged. The state stays in this browser; the exported file is a patch’s reference_matches.'),
      h('div', { class: 'controls' },
        review.isActive ? button('Leave review', () => review.stop(), { title: 'r or Escape' }) : button(review.hasBegun ? 'Continue review' : 'Start review', () => review.start(), { id: 'review-start', title: 'r' }),
        ...(review.isActive ? this.judging() : []),
        button('Export reference_matches.csv', () => this.export(), { id: 'review-export', disabled: !review.hasBegun })),
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
      ? `Match ${at} of ${this.review.matches.length}: segments ${match.left} and ${match.right}, score ${fixed(match.score, 3)}, votes ${fixed(match.votes, 1)}. Judged: ${this.review.eyeVerdict(match) ?? 'not yet'}.`
      : '');
  }
}

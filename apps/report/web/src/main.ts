// SPDX-License-Identifier: BSD-3-Clause
import { readReport } from './data/decode';
import { isOfFiles, isUnconfirmed } from './data/product';
import type { Patch, Report } from './data/schema';
import { Review } from './review/review';
import { ReviewPanel } from './review/review_panel';
import { ScenePanel } from './scene/scene_panel';
import { State } from './state';
import { append, button, h, replace, tabs } from './ui/dom';
import { fixed, percent, words } from './ui/format';
import { themeButton } from './ui/theme';
import { areas } from './views/areas';
import { Acceptance, titleOf } from './views/acceptance';
import { buildingsOf } from './views/buildings';
import { Charts } from './views/charts';
import { Details } from './views/details';
import { figuresOfMethod } from './views/figures_of_method';
import { head, messages } from './views/head';
import { helpDialog } from './views/help';
import { ImagePair } from './views/image_pair';
import { LineTable } from './views/line_table';
import { PatchImages } from './views/patch_images';
import { provenance } from './views/provenance';

/** Sentences about the points, the lines and the unmatched segments. */
function factsOf(patch: Patch): string {
  const { points } = patch;
  const cloud = points ? `${points.n_all.toLocaleString('en')} LIDAR points of ${points.n_read.toLocaleString('en')} read, ${fixed(points.per_m2, 1)} per m²${points.no_data_share === null ? '' : `, ${percent(points.no_data_share)} % of the area without points`}. ` : '';
  const unmatched = Object.entries(patch.images?.n_unmatched ?? {}).map(([reason, n]) => `${words(reason)} ${n}`);
  return cloud + patch.methods.map((m) => {
    const kinds = (kind: string): number => m.lines.filter((l) => l.kind === kind).length;
    const unconfirmed = m.lines.filter(isUnconfirmed).length;
    return `${m.name}: ${m.lines.length} lines, ${kinds('step')} steps, ${kinds('ridge')} ridges${unconfirmed > 0 ? `, ${unconfirmed} unconfirmed` : ''}. `;
  }).join('') + (unmatched.length > 0 ? `Unmatched segments of the first image: ${unmatched.join(', ')}.` : '');
}

/** An evaluation of line files has no image panel unless one of its patches has images. */
const hasImages = (report: Report): boolean => !isOfFiles(report) || report.patches.some((p) => p.images !== null);

class Page {
  private readonly review: Review;
  private readonly scene: ScenePanel;
  private readonly pair: ImagePair;
  private readonly details: Details;
  private readonly reviewPanel: ReviewPanel;
  private readonly charts = new Charts();
  private readonly help = helpDialog();
  private readonly patchHead = h('div', { class: 'patch-head' });
  private readonly patchFacts = h('div');
  private readonly figures = h('section', { id: 'figures' });

  constructor(private readonly state: State, root: HTMLElement) {
    this.review = new Review(state);
    this.scene = new ScenePanel(state);
    this.pair = new ImagePair(state, this.review);
    this.details = new Details(state);
    this.reviewPanel = new ReviewPanel(state, this.review);
    this.lay(root);
    state.onChange((now, before) => {
      if (now.patch !== before.patch) this.showPatch();
      else if (now.method !== before.method) this.showMethod();
    });
    document.addEventListener('keydown', (event) => this.onKey(event));
    this.showPatch();
  }

  private lay(root: HTMLElement): void {
    const { report } = this.state;
    const applyTheme = (): void => { this.scene.view?.applyTheme(); this.charts.show(this.state.method); this.pair.draw(); };
    replace(root,
      h('header', {}, h('h1', {}, titleOf(report)),
        h('div', { class: 'controls' }, themeButton(applyTheme), button('Help (?)', () => this.help.showModal(), { id: 'help-button' }))),
      ...messages(report),
      new Acceptance(this.state).element,
      ...head(report),
      areas(report),
      h('section', { id: 'patch' }, this.patchHead, this.patchFacts,
        h('div', { class: 'views' }, this.scene.element, h('div', {}, hasImages(report) ? this.pair.element : null, this.reviewPanel.element, this.details.element)),
        new LineTable(this.state).element,
        this.charts.element, this.figures),
      provenance(report), this.help);
  }

  private showPatch(): void {
    const { state } = this;
    const { patch, report } = state;
    const patches = tabs('Patch', report.patches.map((p) => p.id), () => state.now.patch, (i) => state.choosePatch(i));
    const methods = tabs(isOfFiles(report) ? 'Line file' : 'Method', patch.methods.map((m) => m.name), () => state.now.method, (i) => state.chooseMethod(i));
    patches.element.id = 'patches';
    methods.element.id = 'methods';
    replace(this.patchHead, h('h2', {}, `Patch ${patch.id}`), patches.element, methods.element,
      h('p', { class: 'caption' }, `CRS ${patch.crs}; coordinates here are relative to ${patch.origin_m.join(', ')} m.`));
    replace(this.patchFacts, h('p', { class: 'caption', id: 'patch-facts' }, factsOf(patch)),
      ...patch.notes.map((note) => h('p', { class: 'message note' }, note)));
    const images = PatchImages.of(patch, () => { this.pair.draw(); });
    this.review.show(images);
    this.pair.show(images);
    this.details.show(images);
    this.reviewPanel.show(images);
    this.scene.show();
    this.showFigures();
  }

  private showMethod(): void {
    this.patchHead.querySelectorAll('#methods button').forEach((b, i) => b.setAttribute('aria-pressed', String(i === this.state.now.method)));
    this.showFigures();
  }

  private showFigures(): void {
    this.charts.show(this.state.method);
    replace(this.figures, ...buildingsOf(this.state), ...figuresOfMethod(this.state.method, this.state.patch, this.state.report.note));
  }

  private onKey(event: KeyboardEvent): void {
    const target = event.target as Element;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches('input, select, textarea') || this.help.open) return;
    const { review, state } = this;
    const inReview: Record<string, () => void> = {
      c: () => review.judge('correct'), f: () => review.judge('false'), u: () => review.judge('unsure'),
      n: () => review.step(1), p: () => review.step(-1), m: () => review.toggleAdding(),
    };
    const anywhere: Record<string, () => void> = {
      '?': () => this.help.showModal(),
      t: () => this.scene.view?.look('top'),
      r: () => (review.isActive ? review.stop() : review.start()),
      Escape: () => (review.isActive ? review.stop() : state.set({ line: null })),
    };
    const action = (review.isActive ? inReview[event.key] : undefined) ?? anywhere[event.key] ?? this.methodKey(event.key);
    if (!action) return;
    event.preventDefault();
    action();
  }

  private methodKey(key: string): (() => void) | undefined {
    const method = Number(key) - 1;
    return /^[1-9]$/.test(key) && method < this.state.patch.methods.length ? () => this.state.chooseMethod(method) : undefined;
  }

  get images(): PatchImages | null {
    return this.pair.shownImages;
  }

  get sceneView(): ScenePanel['view'] {
    return this.scene.view;
  }
}

const root = document.getElementById('app')!;
try {
  const state = new State(readReport());
  const page = new Page(state, root);
  // for tests and the browser console
  Object.assign(globalThis, { ridgeline: { state, scene: page.sceneView, images: () => page.images } });
  document.documentElement.dataset['ready'] = 'true';
} catch (error) {
  append(root, h('p', { class: 'message' }, `The report cannot be shown: ${error instanceof Error ? error.message : String(error)}`));
  throw error;
}

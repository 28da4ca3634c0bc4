// SPDX-License-Identifier: BSD-3-Clause
// The 3D view with its controls and legend; a message if the browser has no WebGL.
import { classColour, distanceSteps, okabeIto, selectionColour, statusColour, surfaceColour } from '../data/colours';
import type { State } from '../state';
import { append, button, checkbox, choice, h, replace } from '../ui/dom';
import { words } from '../ui/format';
import type { LineColouring } from './line_layer';
import { SceneView } from './scene_view';

const aboutSurface = 'points from dense matching of the first two images';

const swatch = (colour: string, text: string): HTMLElement => {
  const mark = h('span', { class: 'swatch', 'aria-hidden': 'true' });
  mark.style.background = colour;
  return h('span', { class: 'legend-item' }, mark, text);
};

export class ScenePanel {
  readonly element = h('section', { id: 'scene-panel' });
  view: SceneView | null = null;
  private readonly legend = h('p', { class: 'legend' });
  private readonly thinned = h('p', { class: 'caption', id: 'thinned' });
  private readonly measured = h('p', { class: 'caption', id: 'measured', role: 'status' });
  private readonly surfaceControl = h('span', { class: 'slot' });
  private isSurfaceShown: boolean | null = null; // null: the reader has not chosen
  private colouring: LineColouring = 'class';
  private isPicking = false;

  constructor(private readonly state: State) {
    append(this.element, h('h3', {}, '3D view'));
    if (!document.createElement('canvas').getContext('webgl2')) {
      append(this.element, h('p', { class: 'message', id: 'no-webgl' }, 'The 3D view is missing because WebGL is not available. See fig8.*.png next to this file; tables, charts and images work.'));
      return;
    }
    this.view = new SceneView();
    append(this.element, this.controls(this.view), this.view.element, this.legend, this.thinned, this.measured);
    this.view.onPick = (line) => { this.isPicking = true; state.set({ line }); this.isPicking = false; };
    this.view.measure.onChange = (text) => { this.measured.textContent = text; };
    state.onChange((now, before) => {
      if (now.patch === before.patch && now.method !== before.method) {
        this.view?.showMethod(state.patch, state.method);
        this.updateLegend();
      }
      this.view?.select(now.line);
      // a line picked in the view is already visible
      if (now.line !== null && now.line !== before.line && !this.isPicking) this.view?.centreOn(now.line);
    });
  }

  private controls(view: SceneView): HTMLElement {
    const measure = button('Measure', () => {
      view.measure.turn(!view.measure.isOn);
      measure.setAttribute('aria-pressed', String(view.measure.isOn));
      view.redraw();
    }, { 'aria-pressed': 'false', id: 'measure' });
    const heights = h('input', { type: 'range', min: 1, max: 5, step: 0.5, value: 1, 'aria-label': 'Height exaggeration', oninput: () => {
      view.exaggerateHeights(Number(heights.value));
      shown.textContent = `heights × ${heights.value}`;
    } });
    const shown = h('span', {}, 'heights × 1');
    return h('div', { class: 'controls' },
      choice<LineColouring>('lines by', [{ value: 'class', text: 'class' }, { value: 'status', text: 'status' }, { value: 'distance', text: 'distance' }], this.colouring,
        (colouring) => { this.colouring = colouring; view.colourLinesBy(colouring); this.updateLegend(); }),
      checkbox('LIDAR', true, (on) => view.setPointsVisible(on)),
      this.surfaceControl,
      checkbox('planes', false, (on) => view.setPlanesVisible(on)),
      h('label', { class: 'field' }, shown, heights),
      button('Top', () => view.look('top'), { title: 't', id: 'view-top' }),
      button('Oblique', () => view.look('oblique')),
      button('Centre', () => { if (this.state.now.line !== null) view.centreOn(this.state.now.line); }, { title: 'on the selected line' }),
      measure);
  }

  show(): void {
    const { patch } = this.state;
    this.view?.show(patch, this.state.method);
    this.updateSurface();
    const { points } = patch;
    this.thinned.textContent = !points ? 'No LIDAR points in this report.'
      : points.n_shown < points.n_all ? `Thinned: ${points.n_shown.toLocaleString('en')} of ${points.n_all.toLocaleString('en')} LIDAR points are shown, every ${Math.round(points.n_all / points.n_shown)}th.`
        : `${points.n_all.toLocaleString('en')} LIDAR points, coloured by the plane used for judging; grey: none.`;
    this.updateLegend();
  }

  /** Shows or hides the surface. Until the reader has chosen, it is shown only if there is no
   * LIDAR. */
  private updateSurface(): void {
    const { view, state: { patch } } = this;
    if (!view) return;
    const isShown = this.isSurfaceShown ?? patch.points === null;
    view.setSurfaceVisible(isShown);
    replace(this.surfaceControl, patch.surface && checkbox('surface', isShown, (on) => {
      this.isSurfaceShown = on;
      view.setSurfaceVisible(on);
    }, { title: aboutSurface }));
  }

  private updateLegend(): void {
    const { lines } = this.state.method;
    const count = (test: (l: (typeof lines)[number]) => boolean): number => lines.filter(test).length;
    const items = this.colouring === 'class'
      ? [...new Set(lines.map((l) => l.class))].map((c) => swatch(classColour(c), `${words(c)} ${count((l) => l.class === c)}`))
      : this.colouring === 'status'
        ? [...new Set(lines.map((l) => l.status))].map((s) => swatch(statusColour(s), `${words(s)} ${count((l) => l.status === s)}`))
        : [...distanceSteps.map((s) => swatch(s.colour, s.text)), swatch(okabeIto.grey, 'not evaluated')];
    replace(this.legend, ...items, h('span', { class: 'legend-item' }, 'dashed: not evaluated'), swatch(selectionColour, 'selected, with its planes'),
      this.state.patch.surface && swatch(`linear-gradient(to right, ${surfaceColour(0)}, ${surfaceColour(1)})`, `surface, low to high: ${aboutSurface}`));
  }
}

// SPDX-License-Identifier: BSD-3-Clause
import { isDark } from '../data/colours';
import { button } from './dom';

/** A button that changes the theme. Until it is pressed, the page follows the system. */
export function themeButton(onchange: () => void): HTMLButtonElement {
  const text = (): string => (isDark() ? 'Light' : 'Dark');
  const toggle = button(text(), () => {
    document.documentElement.dataset['theme'] = isDark() ? 'light' : 'dark';
    toggle.textContent = text();
    onchange();
  }, { id: 'theme', title: 'light or dark' });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { toggle.textContent = text(); onchange(); });
  return toggle;
}

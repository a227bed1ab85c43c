// SPDX-License-Identifier: Apache-2.0
// The bar that stays: where to go, which scheme stands out, light or dark.
import { h } from '../dom';
import { choose, goTo, isolate, isolated, on, theme } from '../state';

export function bar(places: [string, string][], schemes: readonly string[]): HTMLElement {
  const go = h(
    'select',
    {
      'aria-label': 'Go to a section',
      change: () => {
        goTo(go.value);
        go.selectedIndex = 0;
      },
    },
    h('option', { value: '' }, 'Go to …'),
    ...places.map(([id, name]) => h('option', { value: id }, name)),
  );
  const pick = h(
    'select',
    {
      'aria-label': 'Isolate a scheme in every plot',
      change: () => {
        if ((isolated() ?? '') !== pick.value) isolate(pick.value || null);
      },
    },
    h('option', { value: '' }, 'All schemes'),
    ...schemes.map((name) => h('option', { value: name }, name)),
  );
  const name = (): string => (theme() === 'dark' ? 'Light' : 'Dark');
  const light = h(
    'button',
    { type: 'button', class: 'theme', click: () => choose(theme() === 'dark' ? 'light' : 'dark') },
    name(),
  );
  on('theme', () => (light.textContent = name()));
  on('scheme', () => {
    pick.value = isolated() ?? '';
    pick.classList.toggle('chosen', isolated() !== null);
    for (const one of document.querySelectorAll<HTMLElement>('[data-scheme]'))
      one.setAttribute('aria-pressed', String(one.dataset.scheme === isolated()));
  });
  const links = places.map(([id, text]) =>
    h(
      'a',
      {
        href: `#${id}`,
        click: (event) => {
          event.preventDefault();
          goTo(id);
        },
      },
      text,
    ),
  );
  return h('nav', { class: 'bar', 'aria-label': 'Report' }, h('div', { class: 'links' }, ...links), go, pick, light);
}

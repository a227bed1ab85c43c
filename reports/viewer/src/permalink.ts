// SPDX-License-Identifier: Apache-2.0
// The sign beside a title that puts its place into the address.
import { h } from './dom';
import { addressOf, goTo } from './state';

export function permalink(id: string, title: string, spoken: string): HTMLElement {
  return h(
    'a',
    {
      class: 'permalink',
      href: addressOf(id),
      title,
      'aria-label': spoken,
      click: (event) => {
        event.preventDefault();
        goTo(id);
      },
    },
    '#',
  );
}

// SPDX-License-Identifier: Apache-2.0
// Beside a globe: the list of its snapshots, and what its colours mean.
import type { Density } from '../data';
import { h, type Child } from '../dom';
import { shown } from '../numbers';
import { ramp, type Scale } from './colours';
import { titleOf } from './numbers';

export function snapshots(densities: Density[], choose: (index: number) => void): Child {
  if (densities.length < 2) return false;
  const buttons = densities.map((d, i) =>
    h('button', { type: 'button', 'aria-pressed': String(i === 0), click: () => pick(i) }, titleOf(d)),
  );
  const pick = (index: number): void => {
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(i === index)));
    choose(index);
  };
  return h('div', { class: 'snapshots-list', role: 'group', 'aria-label': 'Snapshots' }, ...buttons);
}

export function colourBar(scale: Scale): HTMLElement {
  return h(
    'div',
    { class: 'colour-bar' },
    h('span', {}, shown(scale.low, 2)),
    h('div', { class: 'ramp', style: `background: linear-gradient(to right, ${ramp().join(', ')})` }),
    h('span', {}, shown(scale.high, 2)),
    h('small', {}, `density relative to uniform${scale.log ? ', logarithmic' : ''}`),
  );
}

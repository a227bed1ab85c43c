// SPDX-License-Identifier: Apache-2.0
// The key below a plot: a button a scheme, which isolates it in every plot.
import { h, type Child } from './dom';
import { keySample } from './key';
import { isolate, isolated } from './state';
import type { Look } from './style';

export class Legend {
  private readonly keys: [string, HTMLButtonElement][];

  constructor(
    schemes: readonly string[],
    private readonly lookOf: (scheme: string) => Look,
  ) {
    this.keys = schemes.map((scheme) => [scheme, this.key(scheme)]);
  }

  private key(scheme: string): HTMLButtonElement {
    return h(
      'button',
      {
        type: 'button',
        class: 'key-entry',
        'aria-pressed': 'false',
        title: `Only ${scheme}, in every plot`,
        click: () => isolate(scheme),
      },
      ...keySample(this.lookOf(scheme), scheme),
    );
  }

  element(): Child {
    return (
      this.keys.length > 0 &&
      h('div', { class: 'legend', role: 'group', 'aria-label': 'Schemes' }, ...this.keys.map(([, key]) => key))
    );
  }

  /** After another scheme was isolated, or another theme chosen. */
  refresh(): void {
    for (const [scheme, key] of this.keys) {
      key.setAttribute('aria-pressed', String(scheme === isolated()));
      key.classList.toggle('faded', isolated() !== null && scheme !== isolated());
      key.replaceChildren(...keySample(this.lookOf(scheme), scheme));
    }
  }
}

// SPDX-License-Identifier: Apache-2.0
// What a cost is counted in: CPU time, or what no machine changes.
import { h, type Child } from '../dom';
import type { Plot } from './model';

/** A button a choice, where there is one; `choose` is told the plot over that ordinate. */
export function ordinates(plot: Plot, choose: (choice: Plot) => void): Child[] {
  if (plot.kind !== 'curve' || !plot.others || plot.others.length === 0) return [];
  const choices: [string, Plot][] = [['time', plot], ...plot.others.map((o): [string, Plot] => [o.name, o.plot])];
  const buttons = choices.map(([name, choice]) => {
    const pressed = String(choice === plot);
    return h('button', { type: 'button', 'aria-pressed': pressed, click: () => pick(choice) }, name);
  });
  const pick = (choice: Plot): void => {
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(choices[i]?.[1] === choice)));
    choose(choice);
  };
  return [h('span', { class: 'soft small' }, 'cost in'), ...buttons];
}

// SPDX-License-Identifier: Apache-2.0
// How the key of a plot shows a scheme: its dashes, its marker, its name.
import { svg } from './dom';
import type { Look } from './style';

export function keySample(look: Look, scheme: string): (Node | string)[] {
  const dashes = look.dash === 'solid' ? null : look.dash.join(' ');
  return [
    svg(
      'svg',
      { width: 30, height: 12, viewBox: '0 0 30 12', 'aria-hidden': 'true' },
      svg('path', { d: 'M0 6H30', stroke: look.colour, 'stroke-width': 1.5, 'stroke-dasharray': dashes, fill: 'none' }),
      svg('path', { d: look.outline, fill: look.colour, transform: 'translate(10 1)' }),
    ),
    scheme,
  ];
}

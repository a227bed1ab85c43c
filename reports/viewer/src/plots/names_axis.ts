// SPDX-License-Identifier: Apache-2.0
// The axis along which schemes stand by name.
import { font, type Setting } from './setting';

export const nameRoom = (names: string[], s: Setting): number =>
  Math.min(s.width * 0.4, 14 + 7.3 * Math.max(4, ...names.map((name) => name.length)));

export function namesOption(names: string[], s: Setting): object {
  return {
    type: 'category',
    data: names.map((name) => name || 'no scheme'),
    inverse: true,
    axisTick: { show: false },
    axisLine: { lineStyle: { color: s.paper.line } },
    axisLabel: {
      interval: 0,
      color: s.paper.ink,
      fontFamily: font,
      fontSize: 12,
      width: nameRoom(names, s) - 12,
      overflow: 'truncate',
    },
  };
}

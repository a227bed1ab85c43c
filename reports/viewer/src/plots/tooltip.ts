// SPDX-License-Identifier: Apache-2.0
// What a point says when asked: the numbers as they stand in results.json.
import { textOf } from '../coordinates';
import type { Measurement } from '../data';
import { h } from '../dom';
import { asWritten, exact } from '../numbers';

function lineOf(m: Measurement, withName: boolean): HTMLElement {
  const name = `${asWritten(m.quantity)} ${m.observable === '' ? '' : `of ${asWritten(m.observable)}`}`.trim();
  const unit = m.unit === '' || m.unit === '1' ? '' : ` ${asWritten(m.unit)}`;
  return h(
    'div',
    { class: 'value' },
    withName ? h('span', {}, `${name}: `) : false,
    h('b', {}, exact(m.value)),
    unit,
    m.low !== null || m.high !== null
      ? h('div', { class: 'soft' }, `95 %: [${exact(m.low)}, ${exact(m.high)}]`)
      : false,
  );
}

export function tooltipOf(rows: Measurement[], remark = '', run = ''): HTMLElement {
  const first = rows[0] as Measurement;
  const where = textOf(first.at);
  const statuses = [...new Set(rows.map((m) => m.status))].filter((s) => s !== 'ok' && s !== '');
  const methods = [...new Set(rows.map((m) => m.method))].filter((m) => m !== '').join(', ');
  return h(
    'div',
    { class: 'tip' },
    h(
      'div',
      { class: 'who' },
      first.scheme || asWritten(first.quantity),
      where === '' ? false : h('span', {}, ` · ${where}`),
      run === '' ? false : h('span', {}, ` · ${run}`),
    ),
    ...rows.map((m) => lineOf(m, true)),
    methods === '' ? false : h('div', { class: 'soft' }, methods),
    remark === '' ? false : h('div', { class: 'soft' }, remark),
    ...statuses.map((status) => h('div', { class: 'soft' }, status)),
  );
}

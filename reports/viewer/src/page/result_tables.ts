// SPDX-License-Identifier: Apache-2.0
// Tables of what was measured, fitted and decided.
import { textOf } from '../coordinates';
import { csvOf } from '../csv';
import type { Fit, Measurement, Verdict } from '../data';
import { h, save, type Child } from '../dom';
import { asWritten, exact, orderInterval, shown, shownInterval, shownOrder } from '../numbers';
import { verdictOn } from '../order';
import { chip, schemeChip, table, type Column } from './tables';

const mostRows = 500;

const joined = (m: { quantity: string; observable: string }): string =>
  asWritten(m.quantity) + (m.observable === '' ? '' : ` of ${asWritten(m.observable)}`);
const withoutDt = (m: Measurement): string => textOf(m.at.filter((c) => c.name !== 'dt'));

const useOf = (m: Measurement): string => (m.status !== 'ok' ? m.status : m.used ? 'in the fit' : '');

/** With the rows of an earlier run below those of this one, a column says whose each row is. */
export function measurementTable(own: Measurement[], earlier: Measurement[] | null = null): HTMLElement {
  const rows = earlier ? [...own, ...earlier] : own;
  const columns: Column[] = [
    { name: 'scheme' },
    { name: 'quantity' },
    { name: 'dt', kind: 'n' },
    { name: 'at' },
    { name: 'value', kind: 'n' },
    { name: '95 % interval', kind: 'i' },
    { name: 'unit' },
    { name: 'method' },
    { name: 'use' },
    ...(earlier ? [{ name: 'run' }] : []),
  ];
  const cells = (m: Measurement, i: number): Child[] => [
    m.scheme || '–',
    joined(m),
    shown(m.dt),
    withoutDt(m),
    exact(m.value),
    shownInterval(m.low, m.high),
    asWritten(m.unit),
    m.method,
    useOf(m),
    ...(earlier ? [i < own.length ? 'this' : 'earlier'] : []),
  ];
  const most =
    rows.length > mostRows &&
    h(
      'p',
      { class: 'note' },
      `The first ${mostRows} of ${rows.length}. `,
      h(
        'button',
        { type: 'button', class: 'link', click: () => save('measurements.csv', csvOf(own, earlier), 'text/csv') },
        'All of them as CSV',
      ),
    );
  return h(
    'div',
    {},
    table(
      'measurements',
      columns,
      rows.slice(0, mostRows).map((m, i) => ({ cells: cells(m, i) })),
    ),
    most,
  );
}

export function verdictTable(rows: Verdict[]): HTMLElement {
  const columns: Column[] = [
    { name: 'scheme' },
    { name: 'claim' },
    { name: 'claimed', kind: 'n' },
    { name: 'found', kind: 'n' },
    { name: 'interval', kind: 'i' },
    { name: 'verdict' },
    { name: 'why', kind: 'why' },
  ];
  return table(
    'verdicts',
    columns,
    rows.map((v) => ({
      attributes: { class: 'verdict-row', 'data-verdict': v.verdict },
      cells: [
        schemeChip(v.scheme),
        v.claim,
        shown(v.expected),
        shown(v.estimate),
        shownInterval(v.low, v.high),
        chip(v.verdict),
        v.reason,
      ],
    })),
  );
}

export function fitTable(fits: Fit[], verdicts: Verdict[]): HTMLElement {
  const columns: Column[] = [
    { name: 'scheme' },
    { name: 'quantity' },
    { name: 'order', kind: 'n' },
    { name: '95 % interval', kind: 'i' },
    { name: 'claimed', kind: 'n' },
    { name: 'verdict' },
    { name: 'levels', kind: 'why' },
  ];
  return table(
    'fits',
    columns,
    fits.map((f) => {
      const verdict = verdictOn(verdicts, f);
      return {
        attributes: { class: 'fit' },
        cells: [
          schemeChip(f.scheme),
          joined(f),
          shownOrder(f.order),
          orderInterval(f.low, f.high),
          verdict ? shown(verdict.expected) : '–',
          verdict ? chip(verdict.verdict) : '–',
          f.rule,
        ],
      };
    }),
  );
}

/** The orders alone, short enough to stand beside a plot. */
export function orderTable(fits: Fit[], verdicts: Verdict[]): HTMLElement {
  const columns: Column[] = [
    { name: 'scheme' },
    { name: 'order', kind: 'n' },
    { name: '95 % interval', kind: 'i' },
    { name: 'claimed', kind: 'n' },
    { name: 'verdict' },
  ];
  return table(
    'orders',
    columns,
    fits.map((f) => {
      const verdict = verdictOn(verdicts, f);
      return {
        cells: [
          schemeChip(f.scheme),
          shownOrder(f.order),
          orderInterval(f.low, f.high),
          verdict ? shown(verdict.expected) : '–',
          verdict ? chip(verdict.verdict) : '–',
        ],
      };
    }),
  );
}

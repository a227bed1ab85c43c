// Tables: what was measured, fitted and decided.
import type { Fit, Measurement, Verdict } from '../data';
import { textOf } from '../coordinates';
import { csvOf } from '../csv';
import { h, save, type Child } from '../dom';
import { asWritten, exact, orderInterval, shown, shownInterval, shownOrder } from '../numbers';
import { classOf, symbols, verdictOn } from '../order';
import { isolate } from '../state';
import { words } from '../style';
import type { Kind } from '../data';

const mostRows = 500;

export function chip(kind: Kind, times = 1): HTMLElement {
  return h(
    'span',
    { class: `chip ${classOf(kind)}` },
    h('b', { 'aria-hidden': 'true' }, symbols[kind]),
    ` ${words[kind]}`,
    times > 1 && h('small', {}, ` ×${times}`),
  );
}

/** A name that isolates its scheme. */
export const schemeChip = (scheme: string): Child =>
  scheme === ''
    ? '–'
    : h(
        'button',
        {
          type: 'button',
          class: 'scheme-name',
          'data-scheme': scheme,
          title: `Only ${scheme}, in every plot`,
          click: () => isolate(scheme),
        },
        scheme,
      );

export interface Column {
  name: string;
  kind?: 'n' | 'i' | 'why';
}

/** A first cell names its row. */
export function table(
  label: string,
  columns: Column[],
  rows: { cells: Child[]; attributes?: Record<string, string> }[],
): HTMLElement {
  return h(
    'div',
    { class: 'wide', tabindex: 0, role: 'region', 'aria-label': label },
    h(
      'table',
      {},
      h('thead', {}, h('tr', {}, ...columns.map((c) => h('th', { scope: 'col', class: c.kind }, c.name)))),
      h(
        'tbody',
        {},
        ...rows.map((row) =>
          h(
            'tr',
            row.attributes ?? {},
            ...row.cells.map((cell, i) =>
              i === 0 ? h('th', { scope: 'row' }, cell) : h('td', { class: columns[i]?.kind }, cell),
            ),
          ),
        ),
      ),
    ),
  );
}

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

// SPDX-License-Identifier: Apache-2.0
// What all tables of the page are made of: verdicts as chips, names of schemes, columns and rows.
import type { Kind } from '../data';
import { h, type Child } from '../dom';
import { classOf, symbols } from '../order';
import { isolate } from '../state';
import { words } from '../style';

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

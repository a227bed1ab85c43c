// SPDX-License-Identifier: Apache-2.0
// Schemes × experiments: how many claims hold, are refuted, stay open; a cell opens the list of its claims.
import { kindsByWeight, type Results, type Verdict } from '../data';
import { h, type Child } from '../dom';
import { shown, shownInterval } from '../numbers';
import { classOf, grouped, symbols, tally } from '../order';
import { goTo, isolate } from '../state';
import { words } from '../style';
import { chip, schemeChip, table } from './tables';

const key = (scheme: string, experiment: string): string => JSON.stringify([scheme, experiment]);

function list(scheme: string, experiment: string, rows: Verdict[]): void {
  const close = h(
    'button',
    { type: 'button', class: 'close', 'aria-label': 'Close', click: () => dialog.close() },
    '×',
  );
  const leave = (action: () => void) => () => {
    dialog.close();
    action();
  };
  const dialog: HTMLDialogElement = h(
    'dialog',
    { class: 'claims', close: () => dialog.remove(), click: (event) => event.target === dialog && dialog.close() },
    h(
      'div',
      {},
      close,
      h('h2', {}, `${scheme} · ${experiment}`),
      table(
        'claims',
        [
          { name: 'claim' },
          { name: 'verdict' },
          { name: 'claimed', kind: 'n' },
          { name: 'found', kind: 'n' },
          { name: 'interval', kind: 'i' },
          { name: 'why', kind: 'why' },
        ],
        rows.map((v) => ({
          cells: [
            v.claim || '–',
            chip(v.verdict),
            shown(v.expected),
            shown(v.estimate),
            shownInterval(v.low, v.high),
            v.reason,
          ],
        })),
      ),
      h(
        'p',
        { class: 'actions' },
        h('button', { type: 'button', click: leave(() => goTo(`experiment.${experiment}`)) }, `Go to ${experiment}`),
        h('button', { type: 'button', click: leave(() => isolate(scheme)) }, `Only ${scheme}, in every plot`),
      ),
    ),
  );
  document.body.append(dialog);
  dialog.showModal();
}

function cell(scheme: string, experiment: string, rows: Verdict[] | undefined): Child {
  if (!rows) return h('span', { class: 'none', title: 'nothing claimed' }, '·');
  const counts = tally(rows),
    parts = kindsByWeight.filter((kind) => counts[kind] > 0);
  return h(
    'button',
    {
      type: 'button',
      class: 'cell',
      click: () => list(scheme, experiment, rows),
      'aria-label': `${scheme}, ${experiment}: ${parts.map((kind) => `${counts[kind]} ${words[kind]}`).join(', ')}`,
    },
    ...parts.map((kind) =>
      h(
        'span',
        { class: `chip ${classOf(kind)}` },
        h('b', {}, symbols[kind]),
        kind === 'skipped' ? '' : ` ${counts[kind]}`,
        h('small', {}, ` ${kind === 'holds' && counts[kind] > 1 ? 'hold' : words[kind]}`),
      ),
    ),
  );
}

/** What does not hold, by name, before anything else. */
function openClaims(r: Results): Child {
  const most = 8,
    open = kindsByWeight.slice(0, 2).flatMap((kind) => r.verdicts.filter((v) => v.verdict === kind));
  if (open.length === 0) return false;
  return h(
    'ul',
    { class: 'open' },
    ...open
      .slice(0, most)
      .map((v) =>
        h(
          'li',
          {},
          chip(v.verdict),
          ' ',
          schemeChip(v.scheme),
          ` · ${v.experiment} · ${v.claim}`,
          v.estimate !== null && `: found ${shown(v.estimate)} ${shownInterval(v.low, v.high)}`,
          v.expected !== null && `, claimed ${shown(v.expected)}`,
        ),
      ),
    open.length > most && h('li', { class: 'soft' }, `… and ${open.length - most} more below`),
  );
}

export function board(r: Results, schemes: readonly string[], experiments: readonly string[]): Child {
  if (r.verdicts.length === 0) return false;
  const cells = grouped(r.verdicts, (v) => key(v.scheme, v.experiment));
  const columns = experiments.filter((name) => r.verdicts.some((v) => v.experiment === name));
  const rows = schemes.filter((scheme) => columns.some((name) => cells.has(key(scheme, name))));
  return h(
    'section',
    { id: 'board' },
    h('h2', {}, 'Which claims hold'),
    openClaims(r),
    h(
      'div',
      { class: 'wide board', tabindex: 0, role: 'region', 'aria-label': 'schemes and experiments' },
      h(
        'table',
        {},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('th', { scope: 'col' }, 'scheme'),
            ...columns.map((name) =>
              h(
                'th',
                { scope: 'col' },
                h(
                  'a',
                  {
                    href: `#experiment.${name}`,
                    click: (event) => {
                      event.preventDefault();
                      goTo(`experiment.${name}`);
                    },
                  },
                  name.replace(/_/g, ' '),
                ),
              ),
            ),
          ),
        ),
        h(
          'tbody',
          {},
          ...rows.map((scheme) =>
            h(
              'tr',
              {},
              h('th', { scope: 'row' }, schemeChip(scheme)),
              ...columns.map((name) => h('td', {}, cell(scheme, name, cells.get(key(scheme, name))))),
            ),
          ),
        ),
      ),
    ),
    h(
      'p',
      { class: 'note' },
      '✓ holds: the interval lies inside the claim’s margin. ✗ refuted: it lies outside. ? inconclusive: neither, ' +
        'and no pass. ○ not tried: this effort leaves it out. – skipped: it does not apply here, or is not claimed. · nothing claimed. A cell opens its claims with their reasons; a name isolates its scheme in every plot.',
    ),
  );
}

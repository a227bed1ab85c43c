// SPDX-License-Identifier: Apache-2.0
// What has changed since the earlier run: how the runs differ, then what is worse, open, better or different.
import { changeKinds, changesSentence, comparedSentence } from '../comparison';
import type { Change, ChangeKind, Comparison, Side } from '../comparison';
import { rowsToCsv } from '../csv';
import { kindsByWeight, type Kind, type Results } from '../data';
import { h, save, type Child } from '../dom';
import { asWritten, prose, shown, shownInterval } from '../numbers';
import { symbols } from '../order';
import { goTo } from '../state';
import { chip, schemeChip, table, type Column } from './tables';

const mostRows = 50,
  fewRows = 8;

const meanings: Record<ChangeKind, string> = {
  worse: 'A claim is refuted that was not, or an error has grown or is missing now.',
  'no longer shown to hold': 'A claim that held is inconclusive now, or is made no longer.',
  better: 'A claim is refuted no longer or holds now, or an error has shrunk.',
  different: 'A number that is no error, or a timing, has moved; or a verdict that never was one.',
};
const moods: Record<ChangeKind, Kind> = {
  worse: 'refuted',
  'no longer shown to hold': 'inconclusive',
  better: 'holds',
  different: 'skipped',
};

const signs: Record<ChangeKind, string> = {
  worse: symbols.refuted,
  'no longer shown to hold': symbols.inconclusive,
  better: symbols.holds,
  different: '≠',
};

const title = (kind: ChangeKind, n: number): string => `${kind[0]?.toUpperCase()}${kind.slice(1)}: ${n}`;

/** A verdict or a reason, the number, its interval. */
function cellOf({ text, value, low, high }: Side): Child {
  const kind = kindsByWeight.find((one) => one === text);
  return h(
    'span',
    {},
    kind ? chip(kind) : text,
    value === null && text !== '' ? '' : ` ${shown(value)}`,
    value !== null && h('small', {}, ` ${shownInterval(low, high)}`),
  );
}

/** "× 3": of two numbers of one sign. The estimates behind two verdicts need none. */
function ratioOf({ before, after }: Change): string {
  if (before.text !== '' || after.text !== '') return '–';
  const ratio = (after.value ?? 0) / (before.value ?? 0);
  return Number.isFinite(ratio) && ratio > 0 ? `× ${shown(ratio, 3)}` : '–';
}

const columns: Column[] = [
  { name: 'scheme' },
  { name: 'what' },
  { name: 'dt', kind: 'n' },
  { name: 'before', kind: 'n' },
  { name: 'now', kind: 'n' },
  { name: 'ratio', kind: 'n' },
  { name: 'experiment' },
];

const experimentLink = (name: string): Child =>
  h('button', { type: 'button', class: 'link', click: () => goTo(`experiment.${name}`) }, asWritten(name));

function changeTable(kind: ChangeKind, rows: Change[]): HTMLElement {
  return h(
    'div',
    {},
    h('p', { class: 'note' }, meanings[kind]),
    table(
      title(kind, rows.length),
      columns,
      rows.slice(0, mostRows).map((c) => ({
        attributes: { class: 'change', 'data-kind': c.kind },
        cells: [
          schemeChip(c.scheme),
          asWritten(c.what),
          shown(c.dt),
          cellOf(c.before),
          cellOf(c.after),
          ratioOf(c),
          experimentLink(c.experiment),
        ],
      })),
    ),
    rows.length > mostRows &&
      h('p', { class: 'note' }, `The first ${mostRows} of ${rows.length}; the CSV has all of them.`),
  );
}

/** What is worse or open is never folded away. */
function part(kind: ChangeKind, rows: Change[]): Child {
  if (rows.length === 0) return false;
  const name = [h('b', { 'aria-hidden': 'true' }, signs[kind]), ` ${title(kind, rows.length)}`];
  const attributes = { class: `changed ${moods[kind]}` };
  if (kind === 'worse' || kind === 'no longer shown to hold')
    return h('div', attributes, h('h3', {}, ...name), changeTable(kind, rows));
  return h(
    'details',
    { ...attributes, open: rows.length <= fewRows },
    h('summary', {}, ...name),
    changeTable(kind, rows),
  );
}

function madeOf(r: Results): string {
  const { started, commit, version } = r.provenance;
  const parts = [
    started && started.slice(0, 16).replace('T', ' '),
    version && `version ${version}`,
    commit && `commit ${commit.slice(0, 12)}`,
  ];
  return parts.filter(Boolean).join(', ') || 'of unknown date';
}

/** Machine, build and settings come before any number. */
function runs(c: Comparison, before: Results, after: Results): Child {
  return h(
    'div',
    { class: 'runs' },
    h('p', {}, `Earlier run: ${madeOf(before)}. This run: ${madeOf(after)}.`),
    c.settings.length === 0
      ? h('p', {}, 'Machine, build and settings are the same.')
      : h('p', {}, 'The runs themselves differ in:'),
    c.settings.length > 0 && h('ul', {}, ...c.settings.map((what) => h('li', {}, what))),
    c.timingsLeftOut !== '' && h('p', {}, h('b', {}, 'Timings are not compared'), `: ${prose(c.timingsLeftOut)}.`),
  );
}

const csvColumns = ['kind', 'experiment', 'scheme', 'what', 'dt'];
const sideColumns = ['value', 'low', 'high', 'text'] as const;

export function changesCsv(changes: Change[]): string {
  const head = [...csvColumns, ...['before', 'after'].flatMap((run) => sideColumns.map((name) => `${run}_${name}`))];
  return rowsToCsv(
    head,
    changes.map((c) => [
      c.kind,
      c.experiment,
      c.scheme,
      c.what,
      c.dt,
      ...sideColumns.map((name) => c.before[name]),
      ...sideColumns.map((name) => c.after[name]),
    ]),
  );
}

export function changes(c: Comparison, before: Results, after: Results): HTMLElement {
  const worst = changeKinds.find((kind) => c.changes.some((one) => one.kind === kind)) ?? 'better',
    mood = moods[worst];
  return h(
    'section',
    { id: 'changes' },
    h('h2', {}, 'What has changed'),
    h(
      'div',
      { class: `verdict ${mood}` },
      h('p', { class: 'headline' }, h('b', { 'aria-hidden': 'true' }, signs[worst]), ' ', changesSentence(c.changes)),
      h('p', {}, comparedSentence(c)),
    ),
    runs(c, before, after),
    ...changeKinds.map((kind) =>
      part(
        kind,
        c.changes.filter((one) => one.kind === kind),
      ),
    ),
    c.changes.length > 0 &&
      h(
        'p',
        { class: 'tools' },
        h(
          'button',
          { type: 'button', click: () => save('changes.csv', changesCsv(c.changes), 'text/csv') },
          `CSV of ${c.changes.length === 1 ? 'the change' : `all ${c.changes.length} changes`}`,
        ),
      ),
  );
}

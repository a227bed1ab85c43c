// SPDX-License-Identifier: Apache-2.0
// Where the processor time went, and where the numbers come from.
import type { Charge, Results } from '../data';
import { h, type Child } from '../dom';
import { shown, shownDuration } from '../numbers';
import { grouped } from '../order';
import { table } from './tables';

const facts: [string, string][] = [
  ['version', 'polhode'],
  ['commit', 'commit'],
  ['compiler', 'compiler'],
  ['flags', 'flags'],
  ['cpu', 'CPU'],
  ['isa', 'instruction set'],
  ['generator', 'random bits'],
  ['threads', 'threads'],
  ['seed', 'seed'],
  ['effort', 'effort'],
  ['started', 'started'],
  ['wall_seconds', 'wall time'],
  ['cpu_seconds', 'CPU time'],
];

/** By experiment, the costliest first. */
export function profile(r: Results): Child {
  const seconds = (charges: Charge[]): number => charges.reduce((all, one) => all + one.cpuSeconds, 0),
    total = seconds(r.profile);
  if (!(total > 0)) return false;
  const rows = [...grouped(r.profile, (one) => one.experiment).values()].sort((a, b) => seconds(b) - seconds(a));
  const parts = (charges: Charge[]): string =>
    [...charges]
      .sort((a, b) => b.cpuSeconds - a.cpuSeconds)
      .filter((one) => one.cpuSeconds >= 0.01 * total)
      .map((one) => `${one.scheme || 'other'} ${shown(one.cpuSeconds)}`)
      .join(', ');
  return h(
    'section',
    { id: 'profile' },
    h('h2', {}, 'Where the processor time went'),
    table(
      'processor time',
      [{ name: 'experiment' }, { name: 's', kind: 'n' }, { name: '%', kind: 'n' }, { name: 'of it', kind: 'why' }],
      rows.map((charges) => ({
        attributes: {},
        cells: [
          charges[0]?.experiment ?? '',
          shown(seconds(charges)),
          shown((100 * seconds(charges)) / total),
          parts(charges),
        ],
      })),
    ),
    h('p', { class: 'note' }, 'Other: linear algebra and references before any scheme steps.'),
  );
}

export function provenance(r: Results): HTMLElement {
  const p = r.provenance,
    known = new Set(facts.map(([key]) => key));
  const others = Object.keys(p)
    .filter((key) => !known.has(key))
    .map((key): [string, string] => [key, key.replace(/_/g, ' ')]);
  const value = (key: string): string =>
    key.endsWith('_seconds') ? shownDuration(p[key] ? Number(p[key]) : null) : p[key] || '–';
  return h(
    'footer',
    { id: 'provenance' },
    h('h2', {}, 'Provenance'),
    h(
      'dl',
      { class: 'facts' },
      ...[...facts, ...others].map(([key, name]) => h('div', {}, h('dt', {}, name), h('dd', {}, value(key)))),
      h('div', {}, h('dt', {}, 'schema'), h('dd', {}, `${r.schema.name} ${r.schema.version ?? '–'}`)),
    ),
    h(
      'p',
      { class: 'note' },
      'Every number of this page is in results.json, measurements.csv and verdicts.csv beside it.',
    ),
  );
}

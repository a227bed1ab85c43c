// The end of the page: what the schemes claim, what was left out and why, where the numbers come from.
import type { Charge, Results, Saved, Scheme } from '../data';
import { h, type Child } from '../dom';
import { shown, shownCount, shownDuration } from '../numbers';
import { grouped } from '../order';
import { schemeChip, table } from './tables';

const calculi: Record<string, string> = { ito: 'Itô', stratonovich: 'Stratonovich' };

function claim(s: Scheme, name: string): string {
  const value = s.claims[name];
  return typeof value === 'number' ? shown(value) : '–';
}

export function schemeTable(r: Results): Child {
  if (r.schemes.length === 0) return false;
  const columns = [
    { name: 'scheme' },
    { name: 'form' },
    { name: 'strong, commuting', kind: 'n' as const },
    { name: 'strong, general', kind: 'n' as const },
    { name: 'weak, one vector', kind: 'n' as const },
    { name: 'weak, isotropic', kind: 'n' as const },
    { name: 'weak, general', kind: 'n' as const },
    { name: 'without noise', kind: 'n' as const },
    { name: 'Casimir' },
    { name: 'source', kind: 'why' as const },
  ];
  return h(
    'section',
    { id: 'schemes' },
    h('h2', {}, 'What the schemes claim'),
    table(
      'claims of the schemes',
      columns,
      r.schemes.map((s) => ({
        attributes: { class: 'scheme' },
        cells: [
          h('span', {}, schemeChip(s.name), h('br'), h('small', {}, s.title)),
          `${calculi[s.calculus] ?? s.calculus}, ${s.implicit ? 'implicit' : 'explicit'}${s.areas ? ', Lévy areas' : ''}`,
          ...[
            'strong_commuting',
            'strong_general',
            'weak_one_vector',
            'weak_isotropic',
            'weak_general',
            'deterministic_order',
          ].map((name) => claim(s, name)),
          s.claims.casimir_exact === true ? 'exact' : `drifts, order ${claim(s, 'casimir_order')}`,
          s.source,
        ],
      })),
    ),
    h('p', { class: 'note' }, 'Orders by class of noise; 0: none is claimed.'),
  );
}

function savedText(s: Saved): string {
  const parts = [
    [s.normals_drawn, 'normals'],
    [s.path_steps, 'path-steps'],
    [s.kernels_run, 'kernel calls'],
  ] as const;
  const texts = parts.filter(([count]) => count > 0).map(([count, what]) => `${shownCount(count)} ${what}`);
  if (s.cpu_seconds > 0) texts.push(`${shownDuration(s.cpu_seconds)} of CPU time`);
  return texts.join(', ') || '–';
}

function sum(all: Saved[]): Saved {
  const total: Saved = { normals_drawn: 0, path_steps: 0, kernels_run: 0, cpu_seconds: 0 };
  for (const one of all) for (const key of Object.keys(total) as (keyof Saved)[]) total[key] += one[key];
  return total;
}

function workSentence(r: Results): string {
  const c = r.counters;
  if (Object.keys(c).length === 0) return '';
  const work = c.path_steps
    ? ` This run drew ${shownCount(c.normals_drawn ?? 0)} normals and took ${shownCount(c.path_steps)} path-steps in ` +
      `${shownCount(c.kernels_run ?? 0)} kernel calls.`
    : '';
  return `A result is what one experiment says of one scheme: ${c.results_computed ?? 0} computed in this run, ${c.results_reused ?? 0} taken over.${work}`;
}

export function leftOut(r: Results): HTMLElement {
  const everyone = (scheme: string): string => scheme || 'every scheme';
  const rows = [
    ...r.skipped.map((s) => ({
      kind: 'skip',
      cells: ['skipped', s.experiment, everyone(s.scheme), s.reason, savedText(s.saved)],
    })),
    ...r.savings.map((s) => ({
      kind: 'saving',
      cells: ['not needed', s.experiment, everyone(s.scheme), `${s.what}: ${s.reason}`, savedText(s.saved)],
    })),
    ...[...grouped(r.reused, (one) => JSON.stringify([one.experiment, one.computed])).values()].map((group) => ({
      kind: 'reuse',
      cells: [
        'taken over',
        group[0]?.experiment ?? '',
        group.length === 1 ? (group[0]?.scheme ?? '') : `${group.length} schemes`,
        `from a run of ${group[0]?.computed ?? ''}: the same inputs, the same build`,
        savedText(sum(group.map((one) => one.saved))),
      ],
    })),
  ];
  return h(
    'section',
    { id: 'left-out' },
    h('h2', {}, 'What was not computed, and why'),
    h('p', { class: 'note' }, workSentence(r)),
    rows.length === 0
      ? h('p', { class: 'note' }, 'Nothing was skipped.')
      : table(
          'left out',
          [
            { name: '' },
            { name: 'experiment' },
            { name: 'schemes' },
            { name: 'reason', kind: 'why' },
            { name: 'saved' },
          ],
          rows.map((row) => ({ attributes: { class: row.kind }, cells: row.cells })),
        ),
  );
}

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

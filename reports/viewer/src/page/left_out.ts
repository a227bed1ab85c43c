// SPDX-License-Identifier: Apache-2.0
// What was skipped, not needed or taken over, and why.
import type { Results, Saved } from '../data';
import { h } from '../dom';
import { shownCount, shownDuration } from '../numbers';
import { grouped } from '../order';
import { table } from './tables';

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

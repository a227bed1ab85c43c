// SPDX-License-Identifier: Apache-2.0
// Which scheme to take: the cheapest for each accuracy where costs were measured, else the smallest error that was seen,
// else why it cannot be said.
import type { Measurement, Results } from '../data';
import { h, type Child } from '../dom';
import { prose, shown, shownAccuracy } from '../numbers';
import { grouped } from '../order';
import { picked } from '../plots/pick';
import type { Source } from '../plots/source';
import { extent } from '../plots/scale';
import { schemeChip, table } from './tables';

interface Goal {
  name: string;
  target: string;
  asks: string;
  experiment: string;
  quantities: string[];
}

const goals: Goal[] = [
  {
    name: 'Strong',
    target: 'strong',
    asks: 'each path, close to the true one',
    experiment: 'strong',
    quantities: ['error'],
  },
  { name: 'Weak', target: 'weak', asks: 'expectations at a time', experiment: 'weak', quantities: ['error'] },
  {
    name: 'Stationary',
    target: 'stationary',
    asks: 'long-run means, the Gibbs law',
    experiment: 'gibbs',
    quantities: ['bias'],
  },
  {
    name: 'Energy',
    target: 'energy_law',
    asks: 'the energy law without noise',
    experiment: 'energy',
    quantities: ['law_residual'],
  },
];

interface Choice {
  accuracy: number;
  cost: Measurement;
  next: Measurement | undefined;
}

/** The cheapest for each accuracy that any scheme reaches. */
function choicesFor(r: Results, source: Source, goal: Goal): Choice[] {
  const described = r.plots.find((p) => p.kind === 'reach' && p.of === goal.target),
    plot = described && picked(described, source);
  if (plot?.kind !== 'curve') return [];
  return plot.lines
    .flatMap((line) => line.points)
    .filter((point) => point.filled)
    .map(({ x, rows: [cost, next] }) => ({ accuracy: x, cost: cost as Measurement, next }))
    .sort((a, b) => b.accuracy - a.accuracy);
}

function nextText(next: Measurement | undefined): string {
  if (!next || next.value === null) return 'no other reaches it';
  const [how = '', other = ''] = next.status.split(': ');
  return how.startsWith('tied') ? `tied with ${other}` : `${other} ${shown(next.value, next.value < 1.095 ? 3 : 2)}×`;
}

function costUnit(choices: Choice[]): string {
  return choices[0]?.cost.unit ?? '';
}

function refutedNote(r: Results, schemes: Set<string>): Child {
  const bad = [...schemes].filter((scheme) => r.verdicts.some((v) => v.scheme === scheme && v.verdict === 'refuted'));
  return (
    bad.length > 0 &&
    h('p', { class: 'note warn' }, `✗ ${bad.join(', ')}: a claim is refuted; look at the board first.`)
  );
}

function costs(r: Results, goal: Goal, choices: Choice[]): Child[] {
  return [
    table(
      `cheapest scheme, ${goal.name}`,
      [
        { name: 'error' },
        { name: 'take' },
        { name: 'dt', kind: 'n' },
        { name: 'ns', kind: 'n' },
        { name: 'next best, cost ratio', kind: 'i' },
      ],
      choices.map(({ accuracy, cost, next }) => ({
        cells: [
          shownAccuracy(accuracy),
          schemeChip(cost.scheme),
          shown(cost.dt, 2),
          shown(cost.value, 3),
          nextText(next),
        ],
      })),
    ),
    h('p', { class: 'note' }, costUnit(choices)),
    refutedNote(r, new Set(choices.map((c) => c.cost.scheme))),
  ];
}

/** Each scheme's worst observable at its finest dt; no cost, so no choice. */
function smallest(rows: Measurement[], goal: Goal): { scheme: string; error: number; dt: number }[] {
  const errors = rows.filter(
    (m) =>
      m.experiment === goal.experiment && goal.quantities.includes(m.quantity) && m.value !== null && m.dt !== null,
  );
  return [...grouped(errors, (m) => m.scheme).entries()]
    .map(([scheme, own]) => {
      const [dt] = extent(own.map((m) => m.dt as number));
      const [, error] = extent(own.filter((m) => m.dt === dt).map((m) => Math.abs(m.value as number)));
      return { scheme, error, dt };
    })
    .sort((a, b) => a.error - b.error);
}

function unsaid(r: Results, goal: Goal): string {
  const skips = r.skipped.filter((s) => s.experiment === goal.experiment),
    skipped = skips.find((s) => s.scheme === '') ?? skips[0];
  if (skipped) return `Cannot be said: ${prose(skipped.reason)}`;
  const ran = r.measurements.some((m) => m.experiment === goal.experiment);
  return ran
    ? 'Cannot be said: no error was measured that would tell.'
    : `Cannot be said: experiment ${goal.experiment} was not run.`;
}

function card(r: Results, source: Source, goal: Goal): Child {
  const choices = choicesFor(r, source, goal),
    seen = choices.length > 0 ? [] : smallest(r.measurements, goal).slice(0, 3);
  const body: Child[] =
    choices.length > 0
      ? costs(r, goal, choices)
      : seen.length > 0
        ? [
            h(
              'p',
              { class: 'note' },
              'Costs were not measured, so no choice can be made. Smallest errors seen, of the worst observable:',
            ),
            table(
              `smallest errors, ${goal.name}`,
              [{ name: 'scheme' }, { name: 'error', kind: 'n' }, { name: 'at dt', kind: 'n' }],
              seen.map((one) => ({ cells: [schemeChip(one.scheme), shown(one.error, 2), shown(one.dt, 3)] })),
            ),
          ]
        : [h('p', { class: 'unsaid' }, unsaid(r, goal))];
  return h(
    'div',
    { class: 'card', 'data-goal': goal.target },
    h('h3', {}, goal.name, h('small', {}, ` ${goal.asks}`)),
    ...body,
  );
}

/** Null where there is nothing to choose from: recorded data alone. */
export function advice(r: Results, source: Source): HTMLElement | null {
  if (r.schemes.length === 0 && r.experiments.some((e) => e.name === 'recorded')) return null;
  return h(
    'section',
    { id: 'advice' },
    h('h2', {}, 'Which one should I take?'),
    h('div', { class: 'cards' }, ...goals.map((goal) => card(r, source, goal))),
  );
}

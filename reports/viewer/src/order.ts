// SPDX-License-Identifier: Apache-2.0
// In which order things stand, what belongs together, and how the verdicts count up.
import { kindsByWeight, type Kind, type Results, type Series, type Verdict } from './data';

export type Tally = Record<Kind, number>;

export function tally(rows: Verdict[]): Tally {
  const counts: Tally = { holds: 0, refuted: 0, inconclusive: 0, 'not tried': 0, skipped: 0 };
  for (const row of rows) ++counts[row.verdict];
  return counts;
}

const claims = (n: number): string => `${n} claim${n === 1 ? '' : 's'}`;

/** What matters most, in one short sentence. */
export function headline(t: Tally): string {
  if (t.refuted > 0) return `${claims(t.refuted)} ${t.refuted === 1 ? 'is' : 'are'} refuted.`;
  if (t.inconclusive > 0)
    return `Nothing is refuted, but ${claims(t.inconclusive)} remain${t.inconclusive === 1 ? 's' : ''} open.`;
  return t.holds > 0 ? 'Every claim that was tried holds.' : 'No claim was tried.';
}

export function sentence(t: Tally): string {
  const total = kindsByWeight.reduce((sum, kind) => sum + t[kind], 0);
  const counted = (n: number, what: string): string => `${n} ${n === 1 ? 'is' : 'are'} ${what}`;
  return (
    `${claims(total)}: ${t.holds} hold${t.holds === 1 ? 's' : ''}, ${counted(t.refuted, 'refuted')}, ` +
    `${counted(t.inconclusive, 'inconclusive')}, ${counted(t['not tried'], 'not tried')}, ${counted(t.skipped, 'skipped')}.`
  );
}

export const symbols: Record<Kind, string> = {
  holds: '✓',
  refuted: '✗',
  inconclusive: '?',
  'not tried': '○',
  skipped: '–',
};

/** As a class of the style sheet. */
export const classOf = (kind: Kind): string => kind.replace(' ', '-');

export const worst = (t: Tally): Kind => kindsByWeight.find((kind) => t[kind] > 0) ?? 'skipped';

const unique = (names: Iterable<string>): string[] => [...new Set(names)].filter((name) => name !== '');

/** Declared ones first, then whatever else the results mention. */
export function experimentNames(r: Results): string[] {
  const mentioned = [r.verdicts, r.fits, r.measurements, r.skipped, r.densities].flatMap((rows) =>
    unique((rows as { experiment: string }[]).map((row) => row.experiment)),
  );
  return unique([...r.experiments.map((e) => e.name), ...mentioned]);
}

export function schemeNames(r: Results): string[] {
  const mentioned = [r.verdicts, r.fits, r.measurements, r.skipped].flatMap((rows) =>
    unique((rows as { scheme: string }[]).map((row) => row.scheme)),
  );
  return unique([...r.schemes.map((s) => s.name), ...mentioned]);
}

/** Rows by experiment, in their order. */
export function byExperiment<Row extends { experiment: string }>(rows: Row[]): Map<string, Row[]> {
  return grouped(rows, (row) => row.experiment);
}

export function grouped<Row>(rows: Iterable<Row>, key: (row: Row) => string): Map<string, Row[]> {
  const groups = new Map<string, Row[]>();
  for (const row of rows) {
    const name = key(row),
      group = groups.get(name);
    if (group) group.push(row);
    else groups.set(name, [row]);
  }
  return groups;
}

export const isSame = (a: Series, b: Series): boolean =>
  a.scheme === b.scheme &&
  a.quantity === b.quantity &&
  a.observable === b.observable &&
  a.over === b.over &&
  a.experiment === b.experiment;

/** The verdict that holds a claimed number against this series. */
export const verdictOn = (verdicts: Verdict[], series: Series): Verdict | undefined =>
  verdicts.find((v) => v.expected !== null && v.evidence.some((one) => isSame(one, series)));

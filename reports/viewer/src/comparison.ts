// SPDX-License-Identifier: Apache-2.0
// What has changed since an earlier run: the comparison that the program has made, as plain values.
import { isObject, number, parsed, text, type Json } from './json';

export const changeKinds = ['worse', 'no longer shown to hold', 'better', 'different'] as const;
export type ChangeKind = (typeof changeKinds)[number];

export interface Side {
  value: number | null;
  low: number | null;
  high: number | null;
  text: string; // a verdict, or why a number is missing
}
export interface Change {
  kind: ChangeKind;
  experiment: string;
  scheme: string;
  what: string;
  dt: number | null;
  before: Side;
  after: Side;
}
export interface Comparison {
  settings: string[]; // what differs between the runs themselves
  claims: number;
  numbers: number;
  timings: number;
  withoutInterval: number; // sampled numbers whose noise is unknown: not compared
  timingsLeftOut: string; // why; empty: they were compared
  changes: Change[];
}

function side(x: unknown): Side {
  const o = isObject(x) ? x : {};
  return { value: number(o.value), low: number(o.low), high: number(o.high), text: text(o.text) };
}

const changeOf = (o: Json): Change => ({
  kind: changeKinds.find((kind) => kind === o.kind) ?? 'different',
  experiment: text(o.experiment),
  scheme: text(o.scheme),
  what: text(o.what),
  dt: number(o.dt),
  before: side(o.before),
  after: side(o.after),
});

/** Throws an Error of one line where there is nothing to read. */
export function readComparison(source: string): Comparison {
  const o = parsed(source);
  const list = (x: unknown): unknown[] => (Array.isArray(x) ? x : []);
  return {
    settings: list(o.settings).map(text),
    claims: number(o.claims) ?? 0,
    numbers: number(o.numbers) ?? 0,
    timings: number(o.timings) ?? 0,
    withoutInterval: number(o.without_interval) ?? 0,
    timingsLeftOut: text(o.timings_left_out),
    changes: list(o.changes).filter(isObject).map(changeOf),
  };
}

const counted = (n: number, one: string, many: string): string => `${n} ${n === 1 ? one : many}`;

/** How many there are of each kind, worst first; kinds without any are left out. */
export function changesSentence(changes: Change[]): string {
  if (changes.length === 0) return 'Nothing has changed beyond noise.';
  const endings: Record<ChangeKind, [string, string]> = {
    worse: ['is worse', 'are worse'],
    'no longer shown to hold': ['is no longer shown to hold', 'are no longer shown to hold'],
    better: ['is better', 'are better'],
    different: ['is different', 'are different'],
  };
  const parts = changeKinds.flatMap((kind) => {
    const n = changes.filter((c) => c.kind === kind).length;
    return n === 0 ? [] : [counted(n, ...endings[kind])];
  });
  const worse = changes.some((c) => c.kind === 'worse') ? '' : 'Nothing is worse: ';
  return `${worse}${parts.join(', ')}.`;
}

export function comparedSentence(c: Comparison): string {
  const parts = [counted(c.claims, 'claim', 'claims'), counted(c.numbers, 'number', 'numbers')];
  if (c.timings > 0) parts.push(counted(c.timings, 'timing', 'timings'));
  const unknown =
    c.withoutInterval > 0
      ? ` Not compared: ${counted(c.withoutInterval, 'sampled number', 'sampled numbers')} without an interval.`
      : '';
  return `Compared: ${parts.join(', ')}.${unknown}`;
}

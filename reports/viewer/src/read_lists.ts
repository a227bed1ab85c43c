// SPDX-License-Identifier: Apache-2.0
// Reads the lists of results.json: what each record holds, and what it lacks.
import {
  kindsByWeight,
  type Kind,
  type Measurement,
  type Fit,
  type Verdict,
  type Experiment,
  type Scheme,
  type Saved,
  type Skip,
  type Saving,
  type Reuse,
  type Charge,
  type Density,
} from './data';
import { isObject, number, records, text, type Json } from './json';

const kind = (x: unknown): Kind => (kindsByWeight.includes(x as Kind) ? (x as Kind) : 'inconclusive');

function saved(x: unknown): Saved {
  const o = isObject(x) ? x : {};
  const count = (name: string): number => number(o[name]) ?? 0;
  return {
    normals_drawn: count('normals_drawn'),
    path_steps: count('path_steps'),
    kernels_run: count('kernels_run'),
    cpu_seconds: count('cpu_seconds'),
  };
}

const place = (o: Json) => ({ experiment: text(o.experiment), scheme: text(o.scheme) });
const subject = (o: Json) => ({ ...place(o), quantity: text(o.quantity), observable: text(o.observable) });
const interval = (o: Json) => ({ low: number(o.low), high: number(o.high) });

/** A number that is missing is never "ok". */
function statusOf(o: Json): string {
  const given = o.status === undefined ? 'ok' : text(o.status);
  return given === 'ok' && number(o.value) === null ? 'missing' : given;
}

function placed(o: Json): Pick<Measurement, 'dt' | 'at' | 'over'> {
  const at = records(o.at).map((c) => ({ name: text(c.name), value: number(c.value), unit: text(c.unit) }));
  return { dt: at.find((c) => c.name === 'dt')?.value ?? null, at, over: text(o.over) };
}

const readers = {
  schemes: (o: Json): Scheme => ({
    name: text(o.name),
    title: text(o.title),
    source: text(o.source),
    calculus: text(o.calculus),
    implicit: o.implicit === true,
    areas: o.areas === true,
    claims: isObject(o.claims) ? (o.claims as Scheme['claims']) : {},
    from: text(o.from),
    takes: text(o.takes),
    measured: isObject(o.measured) ? (o.measured as Scheme['measured']) : {},
  }),
  experiments: (o: Json): Experiment => ({
    name: text(o.name),
    question: text(o.question),
    notes: Array.isArray(o.notes) ? o.notes.map(text) : [],
  }),
  measurements: (o: Json): Measurement => ({
    ...subject(o),
    ...placed(o),
    value: number(o.value),
    ...interval(o),
    unit: text(o.unit),
    method: text(o.method),
    status: statusOf(o),
    used: o.used === true,
  }),
  fits: (o: Json): Fit => ({
    ...subject(o),
    over: text(o.over),
    order: number(o.order),
    ...interval(o),
    prefactor: number(o.prefactor),
    status: text(o.status),
    rule: text(o.rule),
  }),
  verdicts: (o: Json): Verdict => ({
    ...place(o),
    claim: text(o.claim),
    expected: number(o.expected),
    estimate: number(o.estimate),
    ...interval(o),
    verdict: kind(o.verdict),
    reason: text(o.reason),
    evidence: records(o.evidence).map((one) => ({ ...subject(one), over: text(one.over) })),
  }),
  skipped: (o: Json): Skip => ({ ...place(o), reason: text(o.reason), saved: saved(o.saved) }),
  savings: (o: Json): Saving => ({ ...place(o), what: text(o.what), reason: text(o.reason), saved: saved(o.saved) }),
  reused: (o: Json): Reuse => ({ ...place(o), computed: text(o.computed), saved: saved(o.saved) }),
  profile: (o: Json): Charge => ({ ...place(o), cpuSeconds: number(o.cpu_seconds) ?? 0 }),
  densities: (o: Json): Density => ({
    ...place(o),
    name: text(o.name),
    time: number(o.time),
    longitudes: number(o.longitudes) ?? 0,
    heights: number(o.heights) ?? 0,
    values: Array.isArray(o.values) ? o.values.map(number) : [],
  }),
};

const required: { [List in keyof typeof readers]?: readonly string[] } = {
  schemes: ['name', 'title', 'source', 'calculus', 'claims'],
  experiments: ['name', 'question'],
  measurements: [
    'experiment',
    'scheme',
    'quantity',
    'observable',
    'at',
    'over',
    'value',
    'low',
    'high',
    'unit',
    'method',
    'status',
    'used',
  ],
  fits: ['experiment', 'scheme', 'quantity', 'order', 'low', 'high', 'prefactor', 'rule'],
  verdicts: ['experiment', 'scheme', 'claim', 'expected', 'estimate', 'verdict', 'reason'],
  skipped: ['experiment', 'scheme', 'reason'],
  densities: ['experiment', 'scheme', 'name', 'longitudes', 'heights', 'values'],
};
const optional = new Set(['savings', 'reused', 'counters', 'densities', 'profile']);

type Row<Name extends keyof typeof readers> = ReturnType<(typeof readers)[Name]>;

/** What is missing is said, and what is there is read. */
export function list<Name extends keyof typeof readers>(document: Json, name: Name, missing: string[]): Row<Name>[] {
  const given = document[name];
  if (given === undefined && optional.has(name)) return [];
  if (!Array.isArray(given)) {
    missing.push(given === undefined ? `no list “${name}”` : `“${name}” is not a list`);
    return [];
  }
  const objects = given.filter(isObject);
  if (objects.length < given.length) missing.push(`“${name}”: ${given.length - objects.length} entries are no records`);
  for (const field of required[name] ?? []) {
    const lacking = objects.reduce((count, o) => count + (o[field] === undefined ? 1 : 0), 0);
    if (lacking > 0) missing.push(`“${name}”: no “${field}” in ${lacking} of ${objects.length}`);
  }
  const read = readers[name] as (o: Json) => Row<Name>;
  return objects.map(read);
}

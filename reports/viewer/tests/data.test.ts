// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { csvOf } from '../src/csv';
import { readResults } from '../src/read';
import { prose, shown, shownAccuracy, shownDuration, slug } from '../src/numbers';
import { experimentNames, headline, schemeNames, sentence, tally, verdictOn } from '../src/order';

const source = readFileSync(new URL('../../../tests/golden/data/results.json', import.meta.url), 'utf8');
const sample = () => readResults(source);

test('the golden sample lacks nothing', () => {
  const r = sample();
  expect(r.missing).toEqual([]);
  expect(r.provenance.seed).toBe('18446744073709551615');
  expect(r.measurements.length).toBe(JSON.parse(source).measurements.length);
  expect(experimentNames(r)).toEqual(['strong', 'weak', 'casimir', 'gibbs', 'stability']);
  expect(schemeNames(r)).toHaveLength(3);
});

test('what is not JSON is refused in one line', () => {
  for (const text of ['', '{', source.slice(0, 500), '[1]', '3']) {
    expect(() => readResults(text)).toThrow(/^These results cannot be read[^\n]*$/);
  }
});

test('what is missing is said, and the rest is kept', () => {
  const r = readResults(
    '{"schema":{"name":"polhode-results","version":7},"measurements":[{"experiment":"a","value":1e999},3]}',
  );
  expect(r.measurements).toHaveLength(1);
  expect(r.measurements[0]).toMatchObject({ experiment: 'a', value: null, status: 'missing', used: false });
  for (const part of ['version 7', 'scene', 'verdicts', 'no descriptions of plots', '1 entries are no records', 'used'])
    expect(r.missing.join('\n')).toContain(part);
});

test('a density must have as many values as bins', () => {
  const d = { experiment: 'a', scheme: 's', name: 'n', time: 1, longitudes: 2, heights: 2, values: [1, 1, 1, 1] };
  const r = readResults(JSON.stringify({ densities: [d, { ...d, values: [1] }] }));
  expect(r.densities).toHaveLength(1);
  expect(r.missing.join()).toContain('1 values for 2 × 2 bins');
});

test('verdicts count up, and belong to the series that they rest on', () => {
  const r = sample(),
    counts = tally(r.verdicts);
  expect(headline(counts)).toBe('1 claim is refuted.');
  expect(sentence(counts)).toBe('7 claims: 2 hold, 1 is refuted, 2 are inconclusive, 1 is not tried, 1 is skipped.');
  expect(verdictOn(r.verdicts, r.fits[0]!)).toMatchObject({ scheme: 'heun', verdict: 'refuted' });
  expect(verdictOn(r.verdicts, r.fits[2]!)).toBeUndefined();
});

test('CSV keeps every digit, and no cell acts', () => {
  const [first, ...lines] = csvOf(sample().measurements).split('\r\n');
  expect(first).toMatch(/^experiment,scheme,.*,method,at,status,used$/);
  expect(lines.join('\n')).toContain('0.3333333333333333');
  expect(lines.join('\n')).toContain('"a|b, ""c"""');
  expect(csvOf([{ ...sample().measurements[0]!, scheme: '=1+1', quantity: '-a' }])).toContain("'=1+1,'-a");
});

test('numbers read as in the other reports', () => {
  expect(shown(1.23456e-5)).toBe('1.235e−5');
  expect(shown(-0.5)).toBe('−0.5');
  expect([shown(0), shown(null), shown(1050, 3), shown(19710.8), shown(1e100)]).toEqual([
    '0',
    '–',
    '1050',
    '19710',
    '1e100',
  ]);
  expect(shownDuration(83.25)).toBe('1 min 23 s');
  expect(shownAccuracy(1e-3)).toBe('10⁻³');
  expect(prose('dh/dt = -theta |Pi x Omega|^2')).toBe('dh/dt = −θ |Π × Ω|²');
  expect(slug('weak', 'error', 'exp(pi3)')).toBe('weak.error.exp-pi3');
});

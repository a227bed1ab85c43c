// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { changesSentence, comparedSentence, readComparison } from '../src/comparison';
import { csvOf } from '../src/csv';
import { earlierPointsIn, pointsIn } from '../src/plots/model';
import { picked } from '../src/plots/pick';
import { Source } from '../src/plots/source';
import { readResults } from '../src/read';

const source = readFileSync(new URL('../../../tests/golden/data/results.json', import.meta.url), 'utf8');

const changes = (...kinds: string[]) => readComparison(JSON.stringify({ changes: kinds.map((kind) => ({ kind })) }));

test('what has changed is one sentence, worst first', () => {
  expect(changesSentence(changes().changes)).toBe('Nothing has changed beyond noise.');
  expect(changesSentence(changes('better', 'worse', 'better').changes)).toBe('1 is worse, 2 are better.');
  expect(changesSentence(changes('different', 'no longer shown to hold').changes)).toBe(
    'Nothing is worse: 1 is no longer shown to hold, 1 is different.',
  );
});

test('what is missing is empty, and what was not compared is said', () => {
  const c = readComparison('{"claims":1,"numbers":2,"without_interval":3,"changes":[{},7]}');
  expect(c.changes).toHaveLength(1);
  expect(c.changes[0]).toMatchObject({ kind: 'different', dt: null, before: { value: null, text: '' } });
  expect(comparedSentence(c)).toBe(
    'Compared: 1 claim, 2 numbers. Not compared: 3 sampled numbers without an interval.',
  );
  expect(() => readComparison('{')).toThrow(/^These results cannot be read[^\n]*$/);
});

test('the earlier run stands behind the curves, apart from their own points', () => {
  const r = readResults(source),
    described = r.plots.find((p) => p.experiment === 'strong')!;
  const earlier = r.measurements
    .filter((m) => m.experiment === 'strong' && m.scheme === 'heun')
    .map((m) => ({ ...m, value: -1 }));
  const now = new Source(r.measurements, r.fits);
  const plot = picked(described, now, new Source(earlier, []))!;
  expect([pointsIn(plot), earlierPointsIn(plot)]).toEqual([10, earlier.length]);
  expect(plot).toMatchObject({ absolute: true, earlier: { rows: earlier, lines: [{ scheme: 'heun', fit: null }] } });
  const alone = picked(described, now)!;
  expect(earlierPointsIn(alone)).toBe(0);
  expect(alone).toMatchObject({ absolute: false });
});

test('a CSV of two runs names the run', () => {
  const rows = readResults(source).measurements.slice(0, 2);
  const lines = csvOf(rows, rows.slice(1)).trim().split('\r\n');
  expect(lines.map((line) => line.split(',').at(-1))).toEqual(['run', 'this', 'this', 'earlier']);
});

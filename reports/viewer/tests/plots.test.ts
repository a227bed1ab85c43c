// SPDX-License-Identifier: Apache-2.0
// The page against the descriptions: it draws the plots that the program names, of the rows that they name.
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import type { Measurement, PlotDescription, Results, Series } from '../src/data';
import { isSame } from '../src/order';
import { pointsIn, schemesIn, type CurvePlot, type MapPlot } from '../src/plots/model';
import { picked, rowsIn } from '../src/plots/pick';
import { Source } from '../src/plots/source';
import { readResults } from '../src/read';

const golden = readFileSync(new URL('../../../tests/golden/data/results.json', import.meta.url), 'utf8');
const sourceOf = (r: Results): Source => new Source(r.measurements, r.fits);

const seriesOf = (p: PlotDescription): Series[] =>
  [
    ...p.lines.flatMap((l) => [l.series, l.across, l.border, ...l.beside]),
    ...p.levels,
    ...p.others.flatMap((o) => o.lines.map((l) => l.series)),
  ].filter((s) => s !== null);

test('every plot that is described is picked, under its id, and holds the rows of its series alone', () => {
  const r = readResults(golden),
    source = sourceOf(r);
  expect(new Set(r.plots.map((p) => p.id)).size).toBe(r.plots.length);
  expect(r.plots.map((p) => p.kind)).toEqual(expect.arrayContaining(['curve', 'matrix', 'map']));
  for (const p of r.plots) {
    const plot = picked(p, source),
      of = seriesOf(p);
    const rows = plot ? plot.rows : rowsIn(p, source);
    expect(plot?.id ?? p.id).toBe(p.id);
    expect(rows.length).toBeGreaterThan(0);
    for (const m of rows) expect(of.some((s) => isSame(m, s))).toBe(true);
    for (const s of of) expect(r.measurements.some((m) => isSame(m, s))).toBe(true);
    if (plot) expect(new Set(schemesIn(plot)).size).toBe(schemesIn(plot).length);
  }
});

test('no measurement of the sample is lost', () => {
  const r = readResults(golden),
    source = sourceOf(r);
  const shown = new Set(r.plots.flatMap((p) => picked(p, source)?.rows ?? rowsIn(p, source)));
  expect(r.measurements.filter((m) => !shown.has(m))).toEqual([]);
});

test('a curve has its points, its fits, the claimed slopes and its levels', () => {
  const r = readResults(golden),
    plots = r.plots.flatMap((p) => picked(p, sourceOf(r)) ?? []);
  const strong = plots.find((p) => p.id === 'strong.error') as CurvePlot;
  expect(pointsIn(strong)).toBe(10);
  expect(strong).toMatchObject({ kind: 'curve', logX: true, logY: true, slopes: [0.5, 1], absolute: false });
  expect(strong.lines.map((l) => [l.scheme, l.fit?.order])).toEqual([
    ['heun', 1],
    ['lie_heun', 1],
  ]);
  expect(strong.lines[0]?.points.map((p) => p.filled)).toEqual([true, true, true, true, false]);
  const drift = plots.find((p) => p.id === 'casimir.drift.casimir') as CurvePlot;
  expect(drift).toMatchObject({ xTitle: 'number of steps', levels: [{ name: 'reference' }] });
  expect(plots.find((p) => p.id === 'weak.error.exp-pi3')).toMatchObject({
    yTitle: 'error of exp(Π₃)',
    absoluteTitle: '|error of exp(Π₃)|',
    absolute: true,
  });
});

test('a map has its cells and its border', () => {
  const r = readResults(golden),
    map = r.plots.flatMap((p) => picked(p, sourceOf(r)) ?? []).find((p) => p.kind === 'map') as MapPlot;
  expect(map).toMatchObject({
    xTitle: 'dt',
    yTitle: 'θ',
    borderTitle: 'largest stable dt',
    across: true,
    signed: false,
  });
  expect(map.panels.map((p) => [p.scheme, p.cells.length, p.border.length])).toEqual([['lie_heun', 9, 3]]);
  expect(map.panels[0]?.cells.filter((c) => c.remark !== '')).toMatchObject([{ x: 0.5, y: 1, value: 1 }]);
});

const row = (quantity: string, observable: string, dt: number, value: number, used = false): Measurement => ({
  experiment: 'w',
  scheme: 'heun',
  quantity,
  observable,
  dt,
  at: [{ name: 'dt', value: dt, unit: 'time' }],
  over: 'dt',
  value,
  low: null,
  high: null,
  unit: 'ns',
  method: 'timed',
  status: 'ok',
  used,
});
const series = (quantity: string, observable: string) => ({ scheme: 'heun', quantity, observable, over: 'dt' });

test('cost and error pair by their step size, and other ordinates keep the points', () => {
  const [cost, error, steps] = ['cost', 'error_at_cost', 'steps_per_time'].map((name) => series(name, 'weak'));
  const front = {
    id: 'w.cost.weak',
    experiment: 'w',
    kind: 'front',
    lines: [{ series: cost, across: error, beside: [steps] }],
    others: [{ name: 'steps', y_title: 'cost [steps]', lines: [{ series: steps, across: error, beside: [cost] }] }],
  };
  const r = readResults(JSON.stringify({ plots: [front] }));
  const rows = [1, 2].flatMap((dt) => [
    row('cost', 'weak', dt, 10 / dt, dt === 1),
    row('error_at_cost', 'weak', dt, dt / 100),
    row('steps_per_time', 'weak', dt, 1 / dt),
  ]);
  const plot = picked(r.plots[0]!, new Source([...rows, row('cost', 'weak', 3, 1)], [])) as CurvePlot;
  expect(plot.lines[0]?.points.map((p) => [p.x, p.y, p.filled])).toEqual([
    [0.01, 10, true],
    [0.02, 5, false],
  ]);
  expect(plot.lines[0]?.points[0]?.rows.map((m) => m.quantity)).toEqual(['error_at_cost', 'cost', 'steps_per_time']);
  const other = plot.others?.[0]?.plot;
  expect(other?.lines[0]?.points.map((p) => [p.x, p.y])).toEqual([
    [0.01, 1],
    [0.02, 0.5],
  ]);
  expect(other).toMatchObject({ yTitle: 'cost [steps]', front: false, hollow: '' });
});

test('what an accuracy costs stands over the accuracy', () => {
  const over = (quantity: string) => ({ ...series(quantity, 'weak'), over: 'accuracy' });
  const reached = (quantity: string, accuracy: number, dt: number, value: number, used = false): Measurement => {
    const of = row(quantity, 'weak', dt, value, used);
    return { ...of, over: 'accuracy', at: [...of.at, { name: 'accuracy', value: accuracy, unit: '' }] };
  };
  const reach = {
    id: 'w.reach.weak',
    experiment: 'w',
    kind: 'reach',
    of: 'weak',
    x: 'accuracy',
    lines: [{ series: over('cost_to_reach'), beside: [over('cost_of_next')] }],
  };
  const r = readResults(JSON.stringify({ plots: [reach] }));
  const rows = [reached('cost_to_reach', 0.1, 1, 5, true), reached('cost_to_reach', 0.01, 1, 7)];
  const next = reached('cost_of_next', 0.1, 1, 1.5);
  const plot = picked(r.plots[0]!, new Source([...rows, next], [])) as CurvePlot;
  expect(plot.lines.map((l) => l.points.map((p) => [p.x, p.y, p.filled, p.rows.length]))).toEqual([
    [
      [0.01, 7, false, 1],
      [0.1, 5, true, 2],
    ],
  ]);
});

test('what this page does not know, or what is not there, is no plot', () => {
  const plots = [{ id: 'a', experiment: 'a', kind: 'hologram' }, { id: 'b', experiment: 'a', kind: 'curve' }, 7];
  const r = readResults(JSON.stringify({ plots }));
  expect(r.plots.map((p) => p.id)).toEqual(['b']);
  expect(picked(r.plots[0]!, sourceOf(r))).toMatchObject({ kind: 'curve', lines: [], rows: [] });
  expect(readResults('{}').missing.join()).toContain('no descriptions of plots');
});

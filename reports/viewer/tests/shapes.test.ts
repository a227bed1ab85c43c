// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { scaleOver, viridis } from '../src/globe/colours';
import { binOf, directionAt, frameOf, mollweideAt, mollweideOf, seen } from '../src/globe/sphere';
import { axisOver } from '../src/plots/scale';

const uniform = (longitudes: number, heights: number) => ({
  experiment: '',
  scheme: '',
  name: '',
  time: null,
  longitudes,
  heights,
  values: Array<number>(longitudes * heights).fill(1),
});

test('axes hold their values, and ticks lie on them', () => {
  for (const values of [
    [1e-300, 1e300],
    [0.2, 0.21],
    [3],
    [1e-12, 1e-3],
    [0.0075, 0.48],
    [-5, 7],
    [0, 0],
    [1e308, -1e308],
    [1.7976931348623157e308],
    [-1.7976931348623157e308],
    [5e-324],
    [],
  ])
    for (const log of [false, true]) {
      const axis = axisOver(values, log);
      expect(Number.isFinite(axis.min) && axis.max > axis.min).toBe(true);
      expect(axis.ticks.length).toBeGreaterThan(0);
      expect(axis.ticks.length).toBeLessThan(60);
      for (const v of values) {
        const at = axis.at(v);
        if (at !== null && Math.abs(v) < 1e307) expect(at >= axis.min && at <= axis.max).toBe(true);
        if (log && v <= 0) expect(at).toBeNull();
      }
      for (const tick of axis.ticks) expect(axis.label(tick)).not.toMatch(/NaN|undefined|Infinity/);
    }
  expect(axisOver([1e-9, 1e-3], true).label(-6)).toBe('10⁻⁶');
  expect(axisOver([0.01, 1], true).label(-1)).toBe('0.1');
});

test('a view is a rotation', () => {
  for (const view of [
    { longitude: 0, latitude: 0 },
    { longitude: 2.1, latitude: -0.7 },
    { longitude: -3, latitude: Math.PI / 2 },
  ]) {
    const frame = frameOf(view);
    frame.forEach((a, i) =>
      frame.forEach((b, j) => expect(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).toBeCloseTo(i === j ? 1 : 0, 12)),
    );
    const [r, u, t] = frame;
    expect(
      [r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]]
        .map((x, i) => x - t[i]!)
        .every((x) => Math.abs(x) < 1e-12),
    ).toBe(true);
    const n = directionAt(view, 0.3, -0.4)!,
      at = seen(view, n);
    expect([at.u, at.v]).toEqual([expect.closeTo(0.3, 12), expect.closeTo(-0.4, 12)]);
    expect(at.front).toBe(true);
  }
  expect(directionAt({ longitude: 0, latitude: 0 }, 0.8, 0.8)).toBeNull();
});

test('the flat map keeps areas, and comes back', () => {
  const d = uniform(8, 4),
    counts = Array<number>(32).fill(0),
    size = 400;
  let inside = 0;
  for (let j = 0; j < size; ++j)
    for (let i = 0; i < 2 * size; ++i) {
      const n = mollweideAt((2 * i + 1) / (2 * size) - 1, 1 - (2 * j + 1) / size);
      if (!n) continue;
      ++inside;
      counts[binOf(d, n)]! += 1;
    }
  for (const count of counts) expect(Math.abs(count / inside - 1 / 32)).toBeLessThan(3e-4);
  for (const [longitude, latitude] of [
    [0, 0],
    [1, 0.5],
    [-3, -1.2],
    [0.2, 1.57],
  ] as const) {
    const n = mollweideAt(...mollweideOf(longitude, latitude))!;
    expect(n[2]).toBeCloseTo(Math.sin(latitude), 9);
    expect(Math.atan2(n[1], n[0])).toBeCloseTo(longitude, 6);
  }
});

test('bins: rows from z = -1 up, longitudes from -pi', () => {
  const d = uniform(128, 64);
  expect(binOf(d, [-1, -1e-9, -0.999])).toBe(0);
  expect(binOf(d, [1e-9, 0, 1])).toBe(63 * 128 + 64);
  expect(binOf(d, [-1, 1e-9, 0])).toBe(32 * 128 + 127);
});

test('colours grow lighter with density', () => {
  const light = (s: number) => {
    const [r, g, b] = viridis(s);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  for (let i = 0; i < 20; ++i) expect(light((i + 1) / 20)).toBeGreaterThan(light(i / 20));
  const deep = scaleOver([{ ...uniform(2, 2), values: [0, 1e-9, 1, 10] }]),
    even = scaleOver([{ ...uniform(2, 2), values: [0.5, 1, 1, 1.5] }]);
  expect([deep.log, deep.low, deep.high, even.log, even.low]).toEqual([true, 1e-3, 10, false, 0]);
  expect([deep.share(0), deep.share(null), deep.share(10)]).toEqual([0, 0, 1]);
  expect(deep.at(deep.share(0.5))).toBeCloseTo(0.5, 12);
});

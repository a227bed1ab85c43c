// SPDX-License-Identifier: Apache-2.0
// What leads the eye in a plot of curves: fitted power laws, claimed slopes, fronts, levels.
import { shown } from '../numbers';
import type { Look } from '../style';
import type { Series } from './charts';
import type { CurvePlot, Line } from './model';
import { extent, type Axis } from './scale';
import { faded, type Setting } from './setting';

export interface Frame {
  plot: CurvePlot;
  s: Setting;
  x: Axis;
  y: Axis;
}
export type Place = [number, number];

/** Values that a logarithm cannot show stand on the floor of the plot. */
export function placed(f: Frame, x: number, y: number): Place {
  return [f.x.at(x) ?? f.x.min, f.y.at(f.plot.absolute && f.y.log ? Math.abs(y) : y) ?? f.y.min];
}

/** The line through the fitted points; the wedge opens from their middle by the interval of the order. */
export function fitSeries(f: Frame, line: Line, look: Look): Series[] {
  const fitted = line.points.filter((p) => p.filled && p.x > 0),
    fit = line.fit;
  const from = fitted[0]?.x,
    to = fitted[fitted.length - 1]?.x;
  if (
    !fit ||
    faded(f.s, line.scheme) ||
    fit.order === null ||
    fit.prefactor === null ||
    from === undefined ||
    to === undefined ||
    !(to > from)
  )
    return [];
  const { order, prefactor } = fit,
    middle = Math.sqrt(from * to),
    pieces = f.x.log && f.y.log ? 8 : 32;
  const along = Array.from({ length: pieces + 1 }, (_, i) => from * (to / from) ** (i / pieces));
  const power =
    (slope: number) =>
    (x: number): Place =>
      placed(f, x, prefactor * middle ** order * (x / middle) ** slope);
  const visible = (p: Place): boolean => p[1] >= f.y.min && p[1] <= f.y.max;
  const series: Series[] = [
    {
      type: 'line',
      name: `fit ${line.scheme}`,
      silent: true,
      symbol: 'none',
      z: 2,
      data: along.map(power(order)).filter(visible),
      lineStyle: { color: look.colour, width: 6, opacity: 0.2, type: 'solid' },
    },
  ];
  if (fit.low !== null && fit.high !== null) {
    const wedge = [...along.map(power(fit.low)), ...along.map(power(fit.high)).reverse()];
    series.push({
      type: 'custom',
      name: `interval ${line.scheme}`,
      silent: true,
      z: 1,
      data: [wedge.flat()],
      clip: true,
      renderItem: (_params: unknown, api: { coord(p: Place): number[] }) => ({
        type: 'polygon',
        shape: { points: wedge.map((p) => api.coord(p)) },
        style: { fill: look.colour, opacity: 0.18 },
      }),
    } as unknown as Series);
  }
  return series;
}

/** Dashed lines of the claimed orders, in a fan from above the points where they are largest. */
export function slopeSeries(f: Frame): Series[] {
  if (!f.x.log || !f.y.log || f.plot.slopes.length === 0) return [];
  const xs = f.plot.lines.flatMap((l) => l.points.map((p) => p.x)).filter((x) => x > 0);
  const [left, right] = extent(xs.map(Math.log10)),
    top = f.y.max - 0.03 * (f.y.max - f.y.min);
  return f.plot.slopes.map((slope) => {
    const length = Math.min(right - left, (0.92 * (f.y.max - f.y.min)) / Math.abs(slope)),
      [from, to] = slope > 0 ? [right, right - length] : [left, left + length];
    return {
      type: 'line',
      name: `slope ${shown(slope)}`,
      symbol: 'none',
      silent: true,
      z: 6,
      data: [
        [from, top],
        [to, top - Math.abs(slope) * length],
      ],
      lineStyle: { color: f.s.paper.soft, width: 1.1, type: [5, 4], opacity: 0.8 },
      endLabel: {
        show: true,
        formatter: `order ${shown(slope).replace(/\b0\.5$/, '½')}`,
        color: f.s.paper.soft,
        fontSize: 11.5,
        offset: [slope > 0 ? 6 : -6, -9],
        align: slope > 0 ? 'left' : 'right',
        backgroundColor: f.s.paper.card,
        padding: [1, 3],
      },
    } as Series;
  });
}

export function frontSeries(f: Frame): Series[] {
  if (!f.plot.front) return [];
  const on = f.plot.lines
    .flatMap((l) => l.points)
    .filter((p) => p.filled)
    .sort((a, b) => a.x - b.x);
  const steps: Place[] = [];
  for (const p of on) {
    const at = placed(f, p.x, p.y),
      before = steps[steps.length - 1];
    steps.push(before ? [at[0], before[1]] : [at[0], f.y.max], at);
  }
  const last = steps[steps.length - 1];
  if (last) steps.push([f.x.max, last[1]]);
  return [
    {
      type: 'line',
      name: 'Pareto front',
      symbol: 'none',
      silent: true,
      z: 2,
      data: steps,
      lineStyle: { color: f.s.paper.ink, width: 1.4, type: 'solid', opacity: 0.7 },
    },
  ];
}

export function levelSeries(f: Frame): Series[] {
  const room = 0.055 * (f.y.max - f.y.min); // a line of text; levels that are closer share the label of one
  const labelled: number[] = [];
  return f.plot.levels.flatMap(({ name, value }) => {
    const at = f.y.at(value);
    if (at === null) return [];
    const free = labelled.every((other) => Math.abs(other - at) > room);
    if (free) labelled.push(at);
    return [
      {
        type: 'line',
        name,
        symbol: 'none',
        silent: true,
        z: 1,
        data: [
          [f.x.min, at],
          [f.x.max, at],
        ],
        lineStyle: { color: f.s.paper.ink, width: 1.2, type: [2, 3] },
        endLabel: {
          show: free,
          formatter: `${name} ${shown(value)}`,
          color: f.s.paper.soft,
          fontSize: 11.5,
          offset: [-8, -9],
          align: 'right',
        },
      } as Series,
    ];
  });
}

export function zeroSeries(f: Frame): Series[] {
  if (f.y.log || f.y.min >= 0 || f.y.max <= 0) return [];
  return [
    {
      type: 'line',
      name: 'zero',
      symbol: 'none',
      silent: true,
      z: 1,
      data: [
        [f.x.min, 0],
        [f.x.max, 0],
      ],
      lineStyle: { color: f.s.paper.line, width: 1, type: 'solid' },
    },
  ];
}

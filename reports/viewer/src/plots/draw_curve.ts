// SPDX-License-Identifier: Apache-2.0
// Curves: markers with their intervals, and what guides.ts draws around them.
import type { Look } from '../style';
import type { Option, Series } from './charts';
import { fitSeries, frontSeries, levelSeries, placed, slopeSeries, zeroSeries, type Frame, type Place } from './guides';
import type { CurvePlot, Line, Point } from './model';
import { axisOver, extent } from './scale';
import { axisOption, faded, keyRows, lookIn, type Item, type Setting } from './setting';

const finite = (values: (number | null | undefined)[]): number[] =>
  values.filter((v): v is number => v !== null && v !== undefined && Number.isFinite(v));

const behind = (plot: CurvePlot, s: Setting): Line[] => (s.earlier ? (plot.earlier?.lines ?? []) : []);

/** What was found before is faint, and lies below. */
interface Weight {
  run: string;
  opacity: number;
  level: number;
}
const now: Weight = { run: 'this run', opacity: 1, level: 0 },
  then: Weight = { run: 'earlier run', opacity: 0.38, level: -2 };

function frameOf(plot: CurvePlot, s: Setting): Frame {
  const points = [...plot.lines, ...behind(plot, s)].flatMap((l) => l.points),
    size = (v: number): number => (plot.absolute && s.logY ? Math.abs(v) : v);
  const values = points.map((p) => size(p.y));
  const [floor] = extent(values.filter((v) => v > 0));
  // A bar that reaches to zero, or far below its point, must not stretch the axis.
  const bars =
    points.length > 3000
      ? []
      : points.flatMap((p) =>
          finite([p.low, p.high])
            .map(size)
            .filter((v) => !s.logY || v > floor / 30),
        );
  const across =
    points.length > 3000 ? [] : points.flatMap((p) => finite([p.xLow, p.xHigh]).filter((v) => !s.logX || v > p.x / 30));
  const y = axisOver([...values, ...bars, ...plot.levels.map((l) => l.value)], s.logY);
  return { plot, s, x: axisOver([...points.map((p) => p.x), ...across], s.logX, 0.06, s.width < 420 ? 5 : 8), y };
}

interface Draw {
  coord(p: Place): number[];
  value(i: number): number;
}

function segment(a: number[], b: number[], style: object): object {
  return { type: 'line', shape: { x1: a[0], y1: a[1], x2: b[0], y2: b[1] }, style };
}

/** Whiskers: up and down for the value, sideways where the abscissa was measured too. */
function barSeries(f: Frame, line: Line, look: Look, { opacity, level }: Weight): Series[] {
  const own = line.points.filter((p) => p.low !== null || p.high !== null || p.xLow != null || p.xHigh != null);
  if (own.length === 0) return [];
  const style = { stroke: look.colour, lineWidth: 1.1, opacity: opacity * (faded(f.s, line.scheme) ? 0.06 : 0.75) };
  const ends = (p: Point): number[] => [
    ...placed(f, p.x, p.y),
    ...placed(f, p.x, p.low ?? p.y),
    ...placed(f, p.x, p.high ?? p.y),
    ...placed(f, p.xLow ?? p.x, p.y),
    ...placed(f, p.xHigh ?? p.x, p.y),
  ];
  // An interval around zero has no lower end that a logarithm of |y| could show.
  const crossing = (p: Point): boolean => f.plot.absolute && f.y.log && (p.low ?? 0) * (p.high ?? 0) < 0;
  return [
    {
      type: 'custom',
      name: `bars ${line.scheme}`,
      silent: true,
      z: 3 + level,
      clip: true,
      data: own.map((p) => {
        const at = ends(p);
        if (crossing(p)) [at[3], at[5]] = [f.y.min, Math.max(at[3] ?? 0, at[5] ?? 0)];
        return at;
      }),
      renderItem: (_params: unknown, api: Draw) => {
        const at = (i: number): number[] => api.coord([api.value(i), api.value(i + 1)]);
        const low = at(2),
          high = at(4),
          left = at(6),
          right = at(8),
          children: object[] = [];
        const cap = (p: number[], dx: number, dy: number): object =>
          segment([(p[0] ?? 0) - dx, (p[1] ?? 0) - dy], [(p[0] ?? 0) + dx, (p[1] ?? 0) + dy], style);
        if (Math.abs((low[1] ?? 0) - (high[1] ?? 0)) > 0.5)
          children.push(segment(low, high, style), cap(low, 3, 0), cap(high, 3, 0));
        if (Math.abs((left[0] ?? 0) - (right[0] ?? 0)) > 0.5)
          children.push(segment(left, right, style), cap(left, 0, 3), cap(right, 0, 3));
        return { type: 'group', children };
      },
    } as unknown as Series,
  ];
}

function pointSeries(f: Frame, line: Line, look: Look, many: boolean, { run, opacity, level }: Weight): Series {
  const dim = faded(f.s, line.scheme),
    hollow = f.plot.hollow !== '',
    solid = opacity * (dim ? 0.1 : 1);
  const data = line.points.map((p) => ({
    value: placed(f, p.x, p.y),
    item: { rows: p.rows, remark: remarkOn(f, p), run: f.plot.earlier ? run : '' } as Item,
    ...(hollow && !p.filled
      ? { itemStyle: { color: f.s.paper.card, borderColor: look.colour, borderWidth: 1.5, opacity: solid } }
      : {}),
  }));
  const style = { color: look.colour, opacity: solid, borderColor: look.colour, borderWidth: 0 };
  const shared = {
    name: (line.scheme || 'no scheme') + (run === now.run ? '' : `, ${run}`),
    symbol: look.symbol,
    silent: dim,
    z: (dim ? 3 : 5) + level,
    data,
    itemStyle: style,
  };
  if (many)
    return {
      ...shared,
      type: 'scatter',
      symbolSize: 3,
      large: true,
      largeThreshold: 2000,
      progressive: 20_000,
    } as unknown as Series;
  return {
    ...shared,
    type: 'line',
    symbolSize: 9,
    showAllSymbol: true,
    triggerLineEvent: false,
    lineStyle: {
      color: look.colour,
      width: 1.3,
      opacity: opacity * (dim ? 0.08 : 0.85),
      type: f.plot.front ? [3, 4] : look.dash,
    },
    emphasis: { scale: 1.35, lineStyle: { width: 1.3 } },
  } as unknown as Series;
}

function remarkOn(f: Frame, p: Point): string {
  const parts: string[] = [];
  if (f.plot.hollow !== '' && !p.filled) parts.push(f.plot.hollow);
  if (f.plot.front && p.filled) parts.push('on the Pareto front');
  if (f.y.log && p.y === 0) parts.push('zero: drawn on the floor of the logarithmic axis');
  return parts.join('; ');
}

export function curveOption(plot: CurvePlot, s: Setting, many: boolean): Option {
  const f = frameOf(plot, s),
    series: Series[] = [...zeroSeries(f), ...levelSeries(f), ...slopeSeries(f), ...frontSeries(f)];
  for (const line of plot.lines) {
    const look = lookIn(s, line.scheme);
    series.push(...fitSeries(f, line, look));
    if (!many) series.push(...barSeries(f, line, look, now));
    series.push(pointSeries(f, line, look, many, now));
  }
  for (const line of behind(plot, s)) {
    const look = lookIn(s, line.scheme);
    if (!many) series.push(...barSeries(f, line, look, then));
    series.push(pointSeries(f, line, look, many, then));
  }
  const rows = keyRows(plot, s);
  const yTitle = (plot.absolute && s.logY && plot.absoluteTitle) || plot.yTitle;
  return {
    grid: { left: s.width < 420 ? 62 : 72, right: 20, top: s.standalone ? 50 : 14, bottom: 48 + 22 * rows },
    xAxis: axisOption(f.x, plot.xTitle, s, 'x'),
    yAxis: axisOption(f.y, yTitle, s, 'y'),
    series,
    ...(s.standalone
      ? {
          legend: {
            bottom: 6,
            data: plot.lines.map((l) => l.scheme || 'no scheme'),
            itemGap: 14,
            itemWidth: 26,
            itemHeight: 9,
            textStyle: { color: s.paper.ink, fontSize: 12 },
          },
        }
      : {}),
  } as Option;
}

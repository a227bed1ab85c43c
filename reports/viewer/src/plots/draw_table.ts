// One value a scheme with its interval; schemes × conditions as coloured numbers.
import { asWritten, shown } from '../numbers';
import { inkOn, mixed } from '../style';
import type { Option, Series } from './charts';
import { axisOption, faded, font, lookIn, type Setting } from './setting';
import type { ComparisonPlot, MatrixPlot } from './model';
import { axisOver, extent, type Axis } from './scale';
import type { Measurement } from '../data';

const nameRoom = (names: string[], s: Setting): number =>
  Math.min(s.width * 0.4, 14 + 7.3 * Math.max(4, ...names.map((name) => name.length)));

function namesOption(names: string[], s: Setting): object {
  return {
    type: 'category',
    data: names.map((name) => name || 'no scheme'),
    inverse: true,
    axisTick: { show: false },
    axisLine: { lineStyle: { color: s.paper.line } },
    axisLabel: {
      interval: 0,
      color: s.paper.ink,
      fontFamily: font,
      fontSize: 12,
      width: nameRoom(names, s) - 12,
      overflow: 'truncate',
    },
  };
}

interface Draw {
  coord(p: unknown[]): number[];
  value(i: number): number;
  size(p: unknown[]): number[];
}

interface Area {
  coordSys: { y: number; height: number };
}

/** A dashed line across all schemes, named above. */
function referenceSeries(plot: ComparisonPlot, x: Axis, s: Setting): Series[] {
  const { reference } = plot,
    at = reference ? x.at(reference.value) : null;
  if (!reference || at === null) return [];
  return [
    {
      type: 'custom',
      name: reference.name,
      silent: true,
      z: 2,
      data: [[at, 0]],
      renderItem: ({ coordSys }: Area, api: Draw) => {
        const [px = 0] = api.coord([at, 0]),
          right = px > s.width * 0.7;
        return {
          type: 'group',
          children: [
            {
              type: 'line',
              shape: { x1: px, y1: coordSys.y, x2: px, y2: coordSys.y + coordSys.height },
              style: { stroke: s.paper.ink, lineWidth: 1.2, lineDash: [4, 4] },
            },
            {
              type: 'text',
              style: {
                x: px,
                y: coordSys.y - 4,
                text: `${reference.name} ${shown(reference.value)}`,
                fill: s.paper.soft,
                fontSize: 11.5,
                fontFamily: font,
                align: right ? 'right' : 'center',
                verticalAlign: 'bottom',
              },
            },
          ],
        };
      },
    } as unknown as Series,
  ];
}

export function comparisonOption(plot: ComparisonPlot, s: Setting): Option {
  const all = plot.entries.flatMap(({ row }) => [row.value, row.low, row.high]).filter((v): v is number => v !== null);
  const x = axisOver([...all, ...(plot.reference ? [plot.reference.value] : [])], s.logX, 0.08, s.width < 420 ? 4 : 7);
  const names = plot.entries.map((e) => e.scheme);
  const at = (v: number | null): number | null => (v === null ? null : (x.at(v) ?? x.min));
  const bars: Series = {
    type: 'custom',
    name: 'bars',
    silent: true,
    z: 3,
    clip: true,
    data: plot.entries.map(({ row }, i) => [
      i,
      at(row.low) ?? at(row.value),
      at(row.high) ?? at(row.value),
      at(row.value),
    ]),
    renderItem: (_: unknown, api: Draw) => {
      const i = api.value(0),
        scheme = names[i] ?? '';
      const a = api.coord([api.value(1), i]),
        b = api.coord([api.value(2), i]);
      const style = { stroke: lookIn(s, scheme).colour, lineWidth: 1.4, opacity: faded(s, scheme) ? 0.1 : 1 };
      const line = (x1 = 0, y1 = 0, x2 = 0, y2 = 0): object => ({ type: 'line', shape: { x1, y1, x2, y2 }, style });
      const [ax = 0, y = 0] = a,
        [bx = 0] = b;
      return {
        type: 'group',
        children: bx - ax < 1 ? [] : [line(ax, y, bx, y), line(ax, y - 4, ax, y + 4), line(bx, y - 4, bx, y + 4)],
      };
    },
  } as unknown as Series;
  const points: Series = {
    type: 'scatter',
    name: 'values',
    z: 5,
    symbolSize: 10,
    data: plot.entries.map(({ scheme, row }, i) => {
      const look = lookIn(s, scheme),
        dim = faded(s, scheme);
      return {
        value: [at(row.value), i],
        item: { rows: [row] },
        symbol: look.symbol,
        itemStyle: { color: look.colour, opacity: dim ? 0.1 : 1 },
      };
    }),
  } as unknown as Series;
  return {
    grid: { left: nameRoom(names, s), right: 22, top: s.standalone ? 64 : 26, bottom: 46 },
    xAxis: axisOption(x, plot.xTitle, s, 'x'),
    yAxis: namesOption(names, s),
    series: [...referenceSeries(plot, x, s), bars, points],
  } as Option;
}

/** The value, or the end that is known. */
function cellText(m: Measurement, digits: number): string {
  if (m.value !== null) return (m.high === null && m.low !== null ? '≥' : '') + shown(m.value, digits);
  return m.high !== null ? `<${shown(m.high, digits)}` : '–';
}

export function matrixOption(plot: MatrixPlot, s: Setting): Option {
  const size = (m: Measurement): number | null => {
    const v = m.value ?? m.high;
    return v === null ? null : plot.log ? (v > 0 ? Math.log10(v) : null) : v;
  };
  const few = plot.columns.length <= 6;
  const sizes = plot.entries.map((e) => size(e.row)).filter((v): v is number => v !== null);
  const [least, most] = extent(sizes);
  const data = plot.entries.map(({ scheme, column, row }) => {
    const v = size(row),
      share = v === null || most <= least ? 0 : (v - least) / (most - least);
    const fill = mixed(s.paper.card, s.paper.negative, 0.06 + 0.74 * share);
    return {
      value: [plot.columns.indexOf(column), plot.schemes.indexOf(scheme)],
      item: { rows: [row] },
      fill,
      scheme,
      text: cellText(row, few ? 4 : 2),
    };
  });
  const series: Series = {
    type: 'custom',
    name: plot.valueTitle,
    data,
    z: 2,
    renderItem: (params: { dataIndex: number }, api: Draw) => {
      const one = data[params.dataIndex];
      if (!one) return null;
      const [cx = 0, cy = 0] = api.coord(one.value),
        [w = 0, h = 0] = api.size([1, 1]),
        opacity = faded(s, one.scheme) ? 0.12 : 1;
      return {
        type: 'group',
        children: [
          {
            type: 'rect',
            shape: { x: cx - w / 2 + 1, y: cy - h / 2 + 1, width: w - 2, height: h - 2, r: 2 },
            style: { fill: one.fill, opacity },
          },
          ...(w < 26
            ? []
            : [
                {
                  type: 'text',
                  silent: true,
                  style: {
                    x: cx,
                    y: cy,
                    text: one.text,
                    fill: inkOn(one.fill),
                    opacity,
                    align: 'center',
                    verticalAlign: 'middle',
                    fontSize: w < 44 ? 9 : 11,
                    fontFamily: font,
                  },
                },
              ]),
        ],
      };
    },
  } as unknown as Series;
  return {
    grid: { left: nameRoom(plot.schemes, s), right: 12, top: s.standalone ? 44 : 8, bottom: few ? 34 : 108 },
    xAxis: {
      type: 'category',
      data: plot.columns.map(asWritten),
      axisTick: { show: false },
      axisLine: { lineStyle: { color: s.paper.line } },
      axisLabel: {
        interval: 0,
        rotate: few ? 0 : 48,
        color: s.paper.ink,
        fontSize: 11.5,
        width: few ? 90 : 118,
        overflow: 'truncate',
      },
    },
    yAxis: namesOption(plot.schemes, s),
    series: [series],
  } as Option;
}

// SPDX-License-Identifier: Apache-2.0
// Schemes × conditions as coloured numbers.
import type { Measurement } from '../data';
import { asWritten, shown } from '../numbers';
import { inkOn, mixed } from '../style';
import type { Option, Series } from './charts';
import type { MatrixPlot } from './model';
import { nameRoom, namesOption } from './names_axis';
import { extent } from './scale';
import { faded, font, type Setting } from './setting';

interface Draw {
  coord(p: unknown[]): number[];
  size(p: unknown[]): number[];
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

// SPDX-License-Identifier: Apache-2.0
// One value a scheme with its interval.
import { shown } from '../numbers';
import type { Option, Series } from './charts';
import type { ComparisonPlot } from './model';
import { nameRoom, namesOption } from './names_axis';
import { axisOver, type Axis } from './scale';
import { axisOption, faded, font, lookIn, type Setting } from './setting';

interface Draw {
  coord(p: unknown[]): number[];
  value(i: number): number;
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

// SPDX-License-Identifier: Apache-2.0
// Maps over two parameters: a panel a scheme, cells drawn to the middle between their neighbours, the border as a line.
import { textOf } from '../coordinates';
import { shown } from '../numbers';
import { inkOn, mixed } from '../style';
import type { Option, Series } from './charts';
import { frameOf, gap, layoutOf, pitch, type Frame } from './map_frame';
import type { BorderPoint, Cell, MapPlot, Panel } from './model';
import type { Axis } from './scale';
import { axisOption, faded, font, type Setting } from './setting';

function colourOf(f: Frame, cell: Cell): string {
  const { paper } = f.s;
  if (cell.value === null) return paper.line;
  if (!f.plot.signed) return mixed(paper.card, paper.share, 0.04 + 0.76 * cell.value);
  return mixed(
    paper.card,
    cell.value > 0 ? paper.positive : paper.negative,
    0.08 + 0.92 * Math.sqrt(Math.abs(cell.value) / f.most),
  );
}

interface Draw {
  coord(p: number[]): number[];
  value(i: number): number;
}

function cellSeries(f: Frame, panel: Panel, index: number): Series {
  const dim = faded(f.s, panel.scheme),
    single = f.plot.panels.length === 1;
  const data = panel.cells.map((cell) => ({
    value: [f.x.at(cell.x) ?? f.x.min, f.y.at(cell.y) ?? f.y.min],
    cell,
    fill: colourOf(f, cell),
    item: { rows: cell.rows, remark: f.plot.signed ? textOf(cell.rows[0]?.at ?? []) : `${f.plot.yTitle} = ${cell.y}` },
  }));
  return {
    type: 'custom',
    name: panel.title || f.plot.valueTitle,
    xAxisIndex: index,
    yAxisIndex: index,
    data,
    z: 1,
    clip: true,
    renderItem: (params: { dataIndex: number }, api: Draw) => {
      const one = data[params.dataIndex];
      if (!one) return null;
      const [x0, x1] = f.across.get(one.cell.x) ?? [0, 0],
        [y0, y1] = f.up.get(one.cell.y) ?? [0, 0];
      const [left = 0, bottom = 0] = api.coord([x0, y0]),
        [right = 0, top = 0] = api.coord([x1, y1]);
      const style = { fill: one.fill, stroke: f.s.paper.grid, lineWidth: 0.6, opacity: dim ? 0.15 : 1 };
      const text = one.cell.remark !== '' ? '×' : single && right - left > 56 ? shown(one.cell.value, 2) : '';
      return {
        type: 'group',
        children: [
          { type: 'rect', shape: { x: left, y: top, width: right - left, height: bottom - top }, style },
          {
            type: 'text',
            silent: true,
            style: {
              x: (left + right) / 2,
              y: (top + bottom) / 2,
              text,
              fill: inkOn(one.fill),
              align: 'center',
              verticalAlign: 'middle',
              fontSize: 11,
              fontFamily: font,
              opacity: dim ? 0.15 : 0.85,
            },
          },
        ],
      };
    },
  } as unknown as Series;
}

/** Where the border stands: between its ends, or at the one that is known. */
const middle = (b: BorderPoint): number | null => b.row.value ?? b.high ?? b.low;

function placeOn(f: Frame, b: BorderPoint): number[] {
  const value = middle(b) ?? 0,
    at = f.plot.across ? [value, b.at] : [b.at, value];
  const clamp = (v: number | null, axis: Axis): number => Math.min(axis.max, Math.max(axis.min, v ?? axis.min));
  return [clamp(f.x.at(at[0] as number), f.x), clamp(f.y.at(at[1] as number), f.y)];
}

function borderSeries(f: Frame, panel: Panel, index: number): Series[] {
  if (panel.border.length === 0) return [];
  const { paper } = f.s,
    dim = faded(f.s, panel.scheme),
    opacity = dim ? 0.15 : 1;
  const data = panel.border.map((b) => {
    const open = b.high === null && b.low !== null ? 'beyond' : b.row.value === null ? 'below' : '';
    return {
      value: placeOn(f, b),
      item: { rows: [b.row] },
      symbol: open === '' ? 'circle' : 'triangle',
      symbolRotate: open === 'beyond' ? -90 : open === 'below' ? 90 : 0,
      symbolSize: open === '' ? 7 : 11,
    };
  });
  const axes = { xAxisIndex: index, yAxisIndex: index };
  return [
    {
      ...axes,
      type: 'line',
      name: `under ${index}`,
      silent: true,
      symbol: 'none',
      z: 3,
      data: data.map((d) => d.value),
      lineStyle: { color: paper.card, width: 4.5, opacity, type: 'solid' },
    },
    {
      ...axes,
      type: 'line',
      name: `${f.plot.borderTitle} ${panel.title}`,
      z: 4,
      data,
      symbolSize: 7,
      lineStyle: { color: paper.ink, width: 1.8, opacity, type: 'solid' },
      itemStyle: { color: paper.ink, borderColor: paper.card, borderWidth: 1, opacity },
    } as unknown as Series,
  ] as Series[];
}

export function mapOption(plot: MapPlot, s: Setting): Option {
  const f = frameOf(plot, s),
    layout = layoutOf(plot, s),
    top = s.standalone ? 58 : 24;
  const spot = (i: number): { left: number; top: number; row: number; column: number } => {
    const column = i % layout.columns,
      row = Math.floor(i / layout.columns);
    return { column, row, left: layout.left + column * (layout.width + gap), top: top + row * pitch(layout) };
  };
  const last = (i: number): boolean => i + layout.columns >= plot.panels.length;
  const titles = plot.panels.flatMap((panel, i) =>
    panel.title === ''
      ? []
      : [
          {
            text: panel.title,
            left: spot(i).left,
            top: spot(i).top - 20,
            padding: 0,
            textStyle: {
              fontSize: 12,
              fontWeight: panel.scheme === s.isolated ? 700 : 500,
              color: faded(s, panel.scheme) ? s.paper.line : s.paper.ink,
              fontFamily: font,
              width: layout.width,
              overflow: 'truncate',
            },
          },
        ],
  );
  const frameTitle = s.standalone
    ? [{ text: plot.title, left: 12, top: 10, textStyle: { fontSize: 15, color: s.paper.ink } }]
    : [];
  return {
    title: [...frameTitle, ...titles] as Option['title'],
    grid: plot.panels.map((_, i) => ({
      left: spot(i).left,
      top: spot(i).top,
      width: layout.width,
      height: layout.height,
    })),
    xAxis: plot.panels.map((_, i) => ({
      ...axisOption(f.x, last(i) ? plot.xTitle : '', s, 'x'),
      gridIndex: i,
      nameGap: 24,
      splitLine: { show: false },
      ...(last(i) ? {} : { axisLabel: { show: false } }),
    })),
    yAxis: plot.panels.map((_, i) => ({
      ...axisOption(f.y, spot(i).column === 0 ? plot.yTitle : '', s, 'y'),
      gridIndex: i,
      nameGap: 40,
      splitLine: { show: false },
      ...(spot(i).column === 0 ? {} : { axisLabel: { show: false } }),
    })),
    series: plot.panels.flatMap((panel, i) => [cellSeries(f, panel, i), ...borderSeries(f, panel, i)]),
  } as Option;
}

// SPDX-License-Identifier: Apache-2.0
// Where the panels of a map stand, its axes, and the edges of its cells.
import { shown } from '../numbers';
import type { MapPlot } from './model';
import { axisOver, extent, type Axis } from './scale';
import type { Setting } from './setting';

export const gap = 26;

export interface Layout {
  columns: number;
  width: number;
  height: number;
  left: number;
}

export function layoutOf(plot: MapPlot, s: Setting): Layout {
  const left = 68,
    single = plot.panels.length === 1;
  const columns = single ? 1 : Math.max(1, Math.min(plot.panels.length, Math.floor((s.width - left) / 210)));
  const width = (s.width - left - 14 - (columns - 1) * gap) / columns;
  return { columns, left, width, height: single ? Math.min(420, Math.max(240, width * 0.62)) : 112 };
}

const rowsIn = (plot: MapPlot, layout: Layout): number => Math.ceil(plot.panels.length / layout.columns);
export const pitch = (layout: Layout): number => layout.height + 44;

export function mapHeight(plot: MapPlot, s: Setting): number {
  const layout = layoutOf(plot, s);
  return rowsIn(plot, layout) * pitch(layout) + 36;
}

/** Edges half way to the neighbours; the outermost cells are as wide outside as inside. */
function edges(values: number[], axis: (v: number) => number | null): Map<number, [number, number]> {
  const sorted = [...new Set(values)].sort((a, b) => a - b),
    at = sorted.map((v) => axis(v) ?? 0);
  const out = new Map<number, [number, number]>();
  sorted.forEach((value, i) => {
    const here = at[i] as number,
      before = at[i - 1],
      after = at[i + 1];
    const down = before === undefined ? (after === undefined ? 0.5 : (after - here) / 2) : (here - before) / 2;
    const up = after === undefined ? (before === undefined ? 0.5 : (here - before) / 2) : (after - here) / 2;
    out.set(value, [here - down, here + up]);
  });
  return out;
}

export interface Frame {
  plot: MapPlot;
  s: Setting;
  x: Axis;
  y: Axis;
  across: Map<number, [number, number]>;
  up: Map<number, [number, number]>;
  most: number;
}

export function frameOf(plot: MapPlot, s: Setting): Frame {
  const cells = plot.panels.flatMap((p) => p.cells),
    xs = cells.map((c) => c.x),
    ys = cells.map((c) => c.y);
  const along = (
    values: number[],
    log: boolean,
    few: boolean,
    named: boolean,
  ): [Axis, Map<number, [number, number]>] => {
    const axis = axisOver(values, log, 0, few ? 4 : 8),
      all = edges(values, axis.at),
      ends = [...all.values()].flat();
    const [min, max] = extent(ends);
    const raw = axis.log ? [10 ** min, 10 ** max] : [min, max];
    const ticked = axisOver(raw, log, 0, few ? 4 : 8),
      rows = [...all.keys()];
    const own =
      named && rows.length <= 8
        ? { ticks: rows.map((v) => axis.at(v) ?? 0), label: (at: number) => shown(axis.log ? 10 ** at : at, 3) }
        : {};
    return [{ ...ticked, ...own, min, max }, all];
  };
  const small = plot.panels.length > 1;
  const [x, across] = along(xs, s.logX, small, !small),
    [y, up] = along(ys, s.logY, small, true);
  const most = Math.max(extent(cells.map((c) => Math.abs(c.value ?? 0)))[1], 1e-300);
  return { plot, s, x, y, across, up, most };
}

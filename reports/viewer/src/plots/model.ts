// SPDX-License-Identifier: Apache-2.0
// What a plot shows, apart from how it is drawn. Every value keeps the measurements it came from.
import type { Fit, Measurement } from '../data';

export interface Point {
  x: number;
  y: number;
  low: number | null;
  high: number | null;
  xLow?: number | null;
  xHigh?: number | null;
  /** Used by the fit, or on the front; hollow otherwise. */
  filled: boolean;
  rows: Measurement[];
}

export interface Line {
  scheme: string;
  points: Point[];
  fit: Fit | null;
}

interface Common {
  id: string;
  experiment: string;
  title: string;
  note: string;
  rows: Measurement[]; // all that stands behind the plot, also what has no place in it
}

/** Values over a step size, a number of steps, an error or a parameter. */
export interface CurvePlot extends Common {
  kind: 'curve';
  xTitle: string;
  yTitle: string;
  logX: boolean;
  logY: boolean;
  lines: Line[];
  slopes: number[]; // claimed, drawn for comparison
  levels: { name: string; value: number }[]; // values that belong to no abscissa
  front: boolean; // filled points are a Pareto front: lower left is better
  hollow: string; // what a hollow marker says
  absolute: boolean; // a logarithm shows |y|
  absoluteTitle: string; // of the ordinate then
  /** The same of the run that this one is held against: lines behind, and their measurements. */
  earlier?: { lines: Line[]; rows: Measurement[] };
  /** The same points over other ordinates, to choose from. */
  others?: { name: string; plot: CurvePlot }[];
}

/** One value a scheme, with its interval. */
export interface ComparisonPlot extends Common {
  kind: 'comparison';
  xTitle: string;
  logX: boolean;
  entries: { scheme: string; row: Measurement }[];
  reference: { value: number; name: string } | null;
}

export interface Cell {
  x: number;
  y: number;
  value: number | null;
  remark: string;
  rows: Measurement[];
}
export interface BorderPoint {
  at: number;
  low: number | null;
  high: number | null;
  remark: string;
  row: Measurement;
}
export interface Panel {
  scheme: string;
  title: string;
  cells: Cell[];
  border: BorderPoint[];
}

/** Values over two parameters, a panel a scheme; `across`: the border gives an x for each y, else a y for each x. */
export interface MapPlot extends Common {
  kind: 'map';
  xTitle: string;
  yTitle: string;
  valueTitle: string;
  borderTitle: string;
  logX: boolean;
  logY: boolean;
  across: boolean;
  signed: boolean;
  panels: Panel[];
}

/** Schemes × conditions. */
export interface MatrixPlot extends Common {
  kind: 'matrix';
  valueTitle: string;
  schemes: string[];
  columns: string[];
  log: boolean;
  entries: { scheme: string; column: string; row: Measurement }[];
}

export type Plot = CurvePlot | ComparisonPlot | MapPlot | MatrixPlot;

/** How many values are drawn: what the tests hold against the data. */
export function pointsIn(plot: Plot): number {
  switch (plot.kind) {
    case 'curve':
      return count(plot.lines);
    case 'map':
      return plot.panels.reduce((n, panel) => n + panel.cells.length + panel.border.length, 0);
    default:
      return plot.entries.length;
  }
}

const count = (lines: Line[]): number => lines.reduce((n, line) => n + line.points.length, 0);

/** Of the earlier run. */
export const earlierPointsIn = (plot: Plot): number =>
  plot.kind === 'curve' && plot.earlier ? count(plot.earlier.lines) : 0;

export function schemesIn(plot: Plot): string[] {
  const names =
    plot.kind === 'curve'
      ? plot.lines.map((l) => l.scheme)
      : plot.kind === 'map'
        ? plot.panels.map((p) => p.scheme)
        : plot.entries.map((e) => e.scheme);
  return [...new Set(names)].filter((name) => name !== '');
}

/** Needs the whole width of the page. */
export const isWide = (plot: Plot): boolean =>
  (plot.kind === 'map' && plot.panels.length > 1) || (plot.kind === 'matrix' && plot.columns.length > 6);

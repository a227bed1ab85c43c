// SPDX-License-Identifier: Apache-2.0
// From the description of a plot to its values: the rows are picked by the series that the description names.
import { caseOf, valueAt } from '../coordinates';
import type { Measurement, PlotDescription, PlotLine } from '../data';
import { asWritten } from '../numbers';
import { grouped } from '../order';
import type { BorderPoint, ComparisonPlot, CurvePlot, Line, MapPlot, MatrixPlot, Panel, Plot, Point } from './model';
import type { Source } from './source';

const remarkOf = (m: Measurement): string => (m.status === 'ok' ? '' : m.status);

const shared = (p: PlotDescription) => ({
  id: p.id,
  experiment: p.experiment,
  title: asWritten(p.title),
  note: asWritten(p.note),
});

/** A value with its interval, over an abscissa. */
const pointOf = (x: number, m: Measurement, filled: boolean, rows: Measurement[]): Point => ({
  x,
  y: m.value as number,
  low: m.low,
  high: m.high,
  filled,
  rows,
});

const besideOf = (source: Source, line: PlotLine, m: Measurement): Measurement[] =>
  line.beside.flatMap((series) =>
    source.of(series).filter((one) => valueAt(one, series.over) === valueAt(m, line.series.over)),
  );

/** Cost over the error of the same step size; `used` says of a cost whether it lies on the front. */
function frontPoints(source: Source, line: PlotLine): Point[] {
  const across = line.across ? source.of(line.across) : [];
  return source.of(line.series).flatMap((m) => {
    const error = across.find((one) => one.dt === m.dt && one.value !== null);
    if (!error || m.value === null) return [];
    const point = pointOf(error.value as number, m, m.used, [error, m, ...besideOf(source, line, m)]);
    return [{ ...point, xLow: error.low, xHigh: error.high }];
  });
}

function pointsOf(p: PlotDescription, source: Source, line: PlotLine): Point[] {
  if (p.kind === 'front') return frontPoints(source, line);
  return source.on(p, line.series).flatMap((m) => {
    const x = valueAt(m, p.x);
    return x === null || m.value === null ? [] : [pointOf(x, m, m.used, [m, ...besideOf(source, line, m)])];
  });
}

/** A line a scheme, where it has points. */
function linesOf(p: PlotDescription, source: Source, described: PlotLine[] = p.lines): Line[] {
  return [...grouped(described, (line) => line.series.scheme)].flatMap(([scheme, own]) => {
    const points = own.flatMap((line) => pointsOf(p, source, line)).sort((a, b) => a.x - b.x);
    const fit = own.map((line) => source.fitOf(line.series)).find((f) => f !== null);
    return points.length === 0 ? [] : [{ scheme, points, fit: fit ?? null }];
  });
}

/** All that stands behind a plot, also what has no value. */
function rowsOf(p: PlotDescription, source: Source): Measurement[] {
  return p.lines.flatMap((line) => [
    ...source.on(p, line.series),
    ...[...line.beside, ...(line.across ? [line.across] : [])].flatMap((series) => source.of(series)),
  ]);
}

function curve(p: PlotDescription, source: Source, before: Source | null): CurvePlot {
  const levels = p.levels.flatMap((series) => source.of(series)).filter((m) => m.value !== null);
  const behind = before && p.kind === 'curve' ? { lines: linesOf(p, before), rows: rowsOf(p, before) } : null;
  const own: CurvePlot = {
    ...shared(p),
    kind: 'curve',
    xTitle: asWritten(p.xTitle),
    yTitle: asWritten(p.yTitle),
    logX: p.logX,
    logY: p.logY,
    lines: linesOf(p, source),
    slopes: p.slopes,
    levels: levels.map((m) => ({ name: m.scheme || m.method, value: m.value as number })),
    front: p.kind === 'front',
    hollow: p.hollow,
    absolute: p.absoluteTitle !== '' || (behind?.rows.some((m) => (m.value ?? 0) < 0) ?? false),
    absoluteTitle: asWritten(p.absoluteTitle),
    rows: source.inOrder([...rowsOf(p, source), ...levels]),
    ...(behind ? { earlier: behind } : {}),
  };
  const others = p.others.map(({ name, title, yTitle, lines }) => {
    // The program knows the front of the times alone.
    const counted = linesOf(p, source, lines).map((l) => ({
      ...l,
      points: l.points.map((at) => ({ ...at, filled: true })),
    }));
    return {
      name,
      plot: { ...own, title: asWritten(title), yTitle: asWritten(yTitle), lines: counted, front: false, hollow: '' },
    };
  });
  return { ...own, others };
}

function comparison(p: PlotDescription, source: Source): ComparisonPlot {
  const rows = source.inOrder(rowsOf(p, source));
  return {
    ...shared(p),
    kind: 'comparison',
    xTitle: asWritten(p.xTitle),
    logX: p.logX,
    entries: rows.filter((m) => m.value !== null).map((row) => ({ scheme: row.scheme, row })),
    rows,
    reference: p.claimed === null ? null : { value: p.claimed, name: 'claimed' },
  };
}

function matrix(p: PlotDescription, source: Source): MatrixPlot {
  const rows = source.inOrder(rowsOf(p, source)),
    column = (m: Measurement): string => caseOf(m, p.conditions);
  return {
    ...shared(p),
    kind: 'matrix',
    valueTitle: asWritten(p.valueTitle),
    schemes: [...new Set(p.lines.map((line) => line.series.scheme))],
    columns: [...new Set(rows.map(column))],
    log: p.logValues,
    entries: rows
      .filter((m) => m.value !== null || m.low !== null || m.high !== null)
      .map((row) => ({ scheme: row.scheme, column: column(row), row })),
    rows,
  };
}

function panelOf(p: PlotDescription, source: Source, line: PlotLine): Panel {
  const { scheme } = line.series,
    along = p.borderAcross ? p.y : p.x;
  const cells = source.on(p, line.series).map((m) => ({
    x: valueAt(m, p.x) as number,
    y: valueAt(m, p.y) as number,
    value: m.value,
    remark: remarkOf(m),
    rows: [m],
  }));
  const border: BorderPoint[] = (line.border ? source.of(line.border) : []).flatMap((row) => {
    const at = valueAt(row, along);
    const known = row.value !== null || row.low !== null || row.high !== null;
    return at === null || !known ? [] : [{ at, low: row.low, high: row.high, remark: remarkOf(row), row }];
  });
  return { scheme, title: scheme, cells, border: border.sort((a, b) => a.at - b.at) };
}

function map(p: PlotDescription, source: Source): MapPlot {
  const panels = p.lines.map((line) => panelOf(p, source, line));
  return {
    ...shared(p),
    kind: 'map',
    xTitle: asWritten(p.xTitle),
    yTitle: asWritten(p.yTitle),
    valueTitle: asWritten(p.valueTitle),
    borderTitle: asWritten(p.borderTitle),
    logX: p.logX,
    logY: p.logY,
    across: p.borderAcross,
    signed: p.diverging,
    panels,
    rows: source.inOrder([...rowsOf(p, source), ...panels.flatMap((panel) => panel.border.map((b) => b.row))]),
  };
}

/** The plot, with the same of an earlier run behind it where there is one; null for a table. */
export function picked(p: PlotDescription, source: Source, before: Source | null = null): Plot | null {
  switch (p.kind) {
    case 'curve':
    case 'front':
    case 'reach':
      return curve(p, source, before);
    case 'comparison':
      return comparison(p, source);
    case 'matrix':
      return matrix(p, source);
    case 'map':
      return map(p, source);
    default:
      return null;
  }
}

/** The rows of a table. */
export const rowsIn = (p: PlotDescription, source: Source): Measurement[] => source.inOrder(rowsOf(p, source));

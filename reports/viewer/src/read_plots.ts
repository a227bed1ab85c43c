// SPDX-License-Identifier: Apache-2.0
// Reads the descriptions of plots.
import {
  plotKinds,
  type PlotAlternative,
  type PlotDescription,
  type PlotKind,
  type PlotLine,
  type Series,
} from './data';
import { isObject, number, numbers, records, text, type Json } from './json';

function readerOf(experiment: string) {
  const series = (x: unknown): Series | null =>
    isObject(x)
      ? {
          experiment,
          scheme: text(x.scheme),
          quantity: text(x.quantity),
          observable: text(x.observable),
          over: text(x.over),
        }
      : null;
  const all = (x: unknown): Series[] => records(x).flatMap((one) => series(one) ?? []);
  const lines = (x: unknown): PlotLine[] =>
    records(x).flatMap((o) => {
      const of = series(o.series);
      if (!of) return [];
      return [{ series: of, across: series(o.across), beside: all(o.beside), border: series(o.border) }];
    });
  const other = (o: Json): PlotAlternative => ({
    name: text(o.name),
    title: text(o.title),
    yTitle: text(o.y_title),
    lines: lines(o.lines),
  });
  return { all, lines, other };
}

function described(o: Json, kind: PlotKind): PlotDescription {
  const read = readerOf(text(o.experiment));
  return {
    id: text(o.id),
    experiment: text(o.experiment),
    kind,
    title: text(o.title),
    note: text(o.note),
    of: text(o.of),
    x: text(o.x),
    y: text(o.y),
    conditions: Array.isArray(o.conditions) ? o.conditions.map(text) : [],
    xTitle: text(o.x_title),
    yTitle: text(o.y_title),
    valueTitle: text(o.value_title),
    borderTitle: text(o.border_title),
    logX: o.log_x === true,
    logY: o.log_y === true,
    logValues: o.log_values === true,
    absoluteTitle: text(o.absolute_title),
    diverging: o.diverging === true,
    borderAcross: o.border_across === true,
    hollow: text(o.hollow),
    slopes: numbers(o.slopes),
    claimed: number(o.claimed),
    lines: read.lines(o.lines),
    levels: read.all(o.levels),
    others: records(o.others).map(read.other),
  };
}

/** Of kinds that this page can show. */
export function plotsOf(document: Json, missing: string[]): PlotDescription[] {
  if (!Array.isArray(document.plots)) missing.push('no descriptions of plots: its numbers stand in tables alone');
  return records(document.plots).flatMap((o) => {
    const kind = plotKinds.find((one) => one === o.kind);
    return kind ? [described(o, kind)] : [];
  });
}

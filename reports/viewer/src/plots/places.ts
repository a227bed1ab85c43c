// What is known at places of a parameter space, "sigma=0.5 theta=1", apart from any scheme: curves and maps.
import type { Measurement } from '../data';
import { asWritten, slug } from '../numbers';
import { grouped } from '../order';
import { hasAbscissa, type Findings } from './findings';
import { missingIn } from './curves';
import type { BorderPoint, CurvePlot, MapPlot, Plot } from './model';
import { spansFactor } from './scale';

export interface Coordinate {
  name: string;
  value: number;
}

/** Empty where the text is no place. */
export function placeOf(text: string): Coordinate[] {
  const words = text.split(' ').map((word) => /^([^=]+)=(-?\d[\d.]*(?:e[-+]?\d+)?)$/i.exec(word));
  if (words.some((found) => found === null)) return [];
  return words.map((found) => ({ name: found?.[1] ?? '', value: Number(found?.[2]) }));
}

const namesOf = (place: Coordinate[]): string[] => place.map((c) => c.name);
const valueAt = (m: Measurement, i: number): number => placeOf(m.observable)[i]?.value ?? 0;

function groupsOf(found: Findings, coordinates: number): Measurement[][] {
  // A value without an interval is a setting, not a result.
  const results = found.rows.filter(
    (m) =>
      m.scheme === '' &&
      !hasAbscissa(m) &&
      (m.value === null || m.low !== null || m.high !== null) &&
      placeOf(m.observable).length === coordinates,
  );
  return [...grouped(results, (m) => JSON.stringify([m.quantity, namesOf(placeOf(m.observable))])).values()];
}

export function placePlots(found: Findings): Plot[] {
  const curves = groupsOf(found, 1),
    maps = groupsOf(found, 2);
  const taken = new Set([...curves, ...maps].flat());
  found.rows = found.rows.filter((m) => !taken.has(m));
  return [...maps.map((rows) => mapOf(found, rows, curves)), ...curves.map((rows) => curveOf(found, rows))];
}

function curveOf(found: Findings, rows: Measurement[]): CurvePlot {
  const first = rows[0] as Measurement,
    [x] = placeOf(first.observable);
  const points = rows
    .filter((m) => m.value !== null)
    .map((m) => ({ x: valueAt(m, 0), y: m.value as number, low: m.low, high: m.high, filled: true, rows: [m] }))
    .sort((a, b) => a.x - b.x);
  const xTitle = asWritten(x?.name ?? ''),
    yTitle = asWritten(first.unit),
    quantity = asWritten(first.quantity);
  return {
    kind: 'curve',
    id: slug(found.experiment, first.quantity),
    experiment: found.experiment,
    title: `${quantity}: ${yTitle} over ${xTitle}`,
    xTitle,
    yTitle,
    logX: spansFactor(
      points.map((p) => p.x),
      3,
    ),
    logY: false,
    lines: [{ scheme: '', points, fit: null }],
    slopes: [],
    levels: [],
    front: false,
    absolute: false,
    hollow: '',
    rows,
    note: missingIn(rows),
  };
}

/** A curve belongs on a map where it gives the map's second coordinate over its first. */
function borderOf(curves: Measurement[][], x: string, y: string): Measurement[] {
  return curves.find(([first]) => first && placeOf(first.observable)[0]?.name === x && first.unit === y) ?? [];
}

function noteOf(value: string, border: Measurement | undefined, rows: Measurement[]): string {
  const parts = [
    `Warm: ${value} is positive; cool: negative.`,
    border ? `Line: ${asWritten(border.quantity)}.` : '',
    missingIn(rows),
  ];
  return parts.filter((part) => part !== '').join(' ');
}

function mapOf(found: Findings, rows: Measurement[], curves: Measurement[][]): MapPlot {
  const first = rows[0] as Measurement,
    [x, y] = namesOf(placeOf(first.observable)) as [string, string];
  const cells = rows.map((m) => ({
    x: valueAt(m, 0),
    y: valueAt(m, 1),
    value: m.value,
    remark: m.status === 'ok' ? '' : m.status,
    rows: [m],
  }));
  const line = borderOf(curves, x, y).filter((m) => m.value !== null);
  const border: BorderPoint[] = line.map((m) => ({ at: valueAt(m, 0), low: m.low, high: m.high, remark: '', row: m }));
  const valueTitle = asWritten(first.quantity.replace(/ map$/, ''));
  return {
    kind: 'map',
    id: slug(found.experiment, first.quantity),
    experiment: found.experiment,
    title: `${valueTitle} over ${asWritten(x)} and ${asWritten(y)}`,
    xTitle: asWritten(x),
    yTitle: asWritten(y),
    valueTitle: valueTitle + (first.unit === '' || first.unit === '1' ? '' : ` [${first.unit}]`),
    borderTitle: line[0] ? asWritten(line[0].quantity) : '',
    logX: spansFactor(
      cells.map((c) => c.x),
      3,
    ),
    logY: spansFactor(
      cells.map((c) => c.y),
      3,
    ),
    across: false,
    signed: true,
    panels: [{ scheme: '', title: '', cells, border }],
    rows: [...rows, ...line],
    note: noteOf(valueTitle, line[0], rows),
  };
}

// Maps of a scheme over dt and one parameter, with the border found by bisection.
import type { Measurement } from '../data';
import { asWritten, slug } from '../numbers';
import { grouped } from '../order';
import type { Findings } from './findings';
import type { BorderPoint, MapPlot, Panel, Plot } from './model';
import { placeOf } from './places';

const isCell = (m: Measurement): boolean =>
  m.scheme !== '' &&
  m.dt !== null &&
  m.dt > 0 &&
  m.steps === null &&
  m.value !== null &&
  placeOf(m.observable).length === 1 &&
  (placeOf(m.observable)[0]?.value ?? 0) > 0;

export function fieldMaps(found: Findings): Plot[] {
  const groups = grouped(found.rows.filter(isCell), (m) =>
    JSON.stringify([m.quantity, placeOf(m.observable)[0]?.name]),
  );
  const plots = [...groups.values()].map((rows) => mapOf(found, rows));
  const taken = new Set([...groups.values()].flat());
  found.rows = found.rows.filter((m) => !taken.has(m)); // a border stays: it is a number of its own, too
  return plots;
}

function panelOf(scheme: string, rows: Measurement[], borders: Measurement[]): Panel {
  const cells = rows.map((m) => ({
    x: m.dt as number,
    y: placeOf(m.observable)[0]?.value ?? 0,
    value: m.value,
    remark: m.status === 'ok' ? '' : m.status,
    rows: [m],
  }));
  const border: BorderPoint[] = borders.map((m) => ({
    at: placeOf(m.observable)[0]?.value ?? 0,
    low: m.low,
    high: m.high,
    remark: m.status === 'ok' ? '' : m.status,
    row: m,
  }));
  return { scheme, title: scheme, cells, border: border.sort((a, b) => a.at - b.at) };
}

function mapOf(found: Findings, rows: Measurement[]): MapPlot {
  const first = rows[0] as Measurement,
    parameter = placeOf(first.observable)[0]?.name ?? '';
  const observables = new Set(rows.map((m) => m.observable)),
    panels: Panel[] = [],
    behind = [...rows];
  for (const scheme of found.schemes) {
    const own = rows.filter((m) => m.scheme === scheme);
    if (own.length === 0) continue;
    const borders = found.rows.filter(
      (m) => m.scheme === scheme && m.dt === null && m.unit === 'time' && observables.has(m.observable),
    );
    behind.push(...borders);
    panels.push(panelOf(scheme, own, borders));
  }
  const quantity = asWritten(first.quantity);
  return {
    kind: 'map',
    id: slug(found.experiment, first.quantity),
    experiment: found.experiment,
    title: `${quantity} over dt and ${asWritten(parameter)}`,
    xTitle: 'dt',
    yTitle: asWritten(parameter),
    valueTitle: quantity,
    borderTitle: asWritten(behind[rows.length]?.quantity ?? ''),
    logX: true,
    logY: true,
    across: true,
    signed: false,
    panels,
    rows: behind,
    note:
      '×: crossed for the reason that its tooltip gives. Empty: not tried. Line: the border by bisection; ▶ nothing tried ' +
      'lies beyond it, ◀ everything does.',
  };
}

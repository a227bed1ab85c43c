// Values over dt or over numbers of steps; values beside each other where each scheme has one only; schemes × conditions.
import type { Measurement } from '../data';
import { asWritten, slug } from '../numbers';
import { expectedOf, grouped, verdictOn } from '../order';
import { hasAbscissa, type Findings } from './findings';
import type { ComparisonPlot, CurvePlot, Line, MatrixPlot, Plot, Point } from './model';
import { spansFactor } from './scale';

const abscissa = (m: Measurement): number => (m.steps ?? m.dt) as number;
const key = (m: Measurement): string => JSON.stringify([m.quantity, m.observable]);

export function titleOf(m: Measurement, absolute = false): string {
  const quantity = asWritten(m.quantity);
  const of =
    m.observable === ''
      ? ''
      : / (from|to|at|over)$/.test(quantity)
        ? ` (${asWritten(m.observable)})`
        : ` of ${asWritten(m.observable)}`;
  const unit = m.unit === '' || m.unit === '1' ? '' : ` [${asWritten(m.unit)}]`;
  return (absolute ? `|${quantity}${of}|` : quantity + of) + unit;
}

/** "2 values are missing: not finite" */
export function missingIn(rows: Measurement[]): string {
  const missing = rows.filter((m) => m.value === null);
  if (missing.length === 0) return '';
  const reasons = [...new Set(missing.map((m) => m.status))].slice(0, 3).join('; ');
  return `${missing.length} value${missing.length === 1 ? ' is' : 's are'} missing: ${reasons}.`;
}

export function curvePlots(found: Findings): Plot[] {
  const curve = (m: Measurement): string => key(m) + (m.steps !== null);
  const over = grouped(found.rows.filter(hasAbscissa), curve),
    behind = found.earlier && grouped(found.earlier.filter(hasAbscissa), curve);
  const standing = grouped(
    found.rows.filter((m) => !hasAbscissa(m) && m.value !== null),
    key,
  );
  const plots: Plot[] = [],
    taken = new Set<Measurement>();
  const ofSchemes = (rows: Measurement[]): boolean => rows[0]?.scheme !== '';
  const ordered = [...over.values()];
  for (const rows of [...ordered.filter(ofSchemes), ...ordered.filter((rows) => !ofSchemes(rows))]) {
    const first = rows[0] as Measurement;
    const levels = standing.get(key(first)) ?? [];
    const plot = oneEach(rows)
      ? comparisonOf(found, rows)
      : curveOf(found, rows, levels, behind && (behind.get(curve(first)) ?? []));
    plots.push(plot);
    for (const m of rows) taken.add(m);
    if (plot.kind === 'curve') for (const m of levels) taken.add(m);
  }
  found.rows = found.rows.filter((m) => !taken.has(m));
  return plots;
}

/** Every scheme at one abscissa: nothing that a curve could show. */
function oneEach(rows: Measurement[]): boolean {
  const schemes = new Set(rows.map((m) => m.scheme));
  return schemes.size > 1 && schemes.size === rows.length;
}

const pointOf = (m: Measurement): Point => ({
  x: abscissa(m),
  y: m.value as number,
  low: m.low,
  high: m.high,
  filled: m.fitted,
  rows: [m],
});

function linesOf(found: Findings, rows: Measurement[]): Line[] {
  const first = rows[0] as Measurement,
    byScheme = grouped(
      rows.filter((m) => m.value !== null),
      (m) => m.scheme,
    );
  const lines: Line[] = [];
  for (const scheme of [...found.schemes, '']) {
    const points = byScheme
      .get(scheme)
      ?.map(pointOf)
      .sort((a, b) => a.x - b.x);
    if (!points) continue;
    const fit = found.fits.find(
      (f) =>
        f.scheme === scheme &&
        f.quantity === first.quantity &&
        f.observable === first.observable &&
        f.order !== null &&
        (f.prefactor ?? 0) > 0,
    );
    lines.push({ scheme, points, fit: fit ?? null });
  }
  return lines;
}

/** Claimed orders of the fitted lines, at most four. */
function slopesOf(found: Findings, lines: Line[]): number[] {
  const slopes = new Set<number>();
  for (const { fit } of lines) {
    const claimed = fit ? verdictOn(found.verdicts, fit)?.expected : null;
    if (claimed && slopes.size < 4) slopes.add(claimed);
  }
  return [...slopes].sort((a, b) => a - b);
}

function curveOf(found: Findings, rows: Measurement[], levels: Measurement[], behind: Measurement[] | null): CurvePlot {
  const first = rows[0] as Measurement,
    lines = linesOf(found, rows),
    fitted = lines.some((l) => l.fit);
  const values = rows.flatMap((m) => (m.value === null ? [] : [m.value]));
  const logY = fitted || spansFactor(values, 30),
    overSteps = first.steps !== null;
  const absolute = [...rows, ...(behind ?? [])].some((m) => m.value !== null && m.value < 0);
  const logX = spansFactor(rows.map(abscissa), 3) && (logY || overSteps || !fitted);
  const yTitle = titleOf(first);
  const filled = lines.some((l) => l.points.some((p) => p.filled));
  return {
    kind: 'curve',
    id: slug(found.experiment, first.quantity, first.observable),
    experiment: found.experiment,
    title: yTitle,
    xTitle: overSteps ? asWritten(first.abscissa) || 'number of steps' : 'step size dt',
    yTitle,
    logX,
    logY,
    lines,
    slopes: slopesOf(found, lines),
    front: false,
    absolute,
    ...(behind ? { earlier: { lines: linesOf(found, behind), rows: behind } } : {}),
    rows: [...rows, ...levels],
    levels: levels.map((m) => ({ name: m.scheme || m.method, value: m.value as number })),
    hollow: filled ? 'dropped by the rule of the fit' : '',
    note: missingIn(rows),
  };
}

export function comparisonOf(found: Findings, rows: Measurement[]): ComparisonPlot {
  const first = rows[0] as Measurement;
  const entries = rows.filter((m) => m.value !== null).map((row) => ({ scheme: row.scheme, row }));
  const claimed = new Set(entries.map(({ row }) => expectedOf(found.verdicts, row)));
  const [value = null] = claimed;
  const dts = new Set(rows.map((m) => m.dt));
  const at = dts.size === 1 && first.dt !== null ? ` at dt = ${first.dt}` : '';
  const reaching = rows.flatMap((m) => (m.value === null ? [] : [m.value, ...(m.low === null ? [] : [m.low])]));
  return {
    kind: 'comparison',
    id: slug(found.experiment, first.quantity, first.observable),
    experiment: found.experiment,
    title: titleOf(first) + at,
    xTitle: titleOf(first),
    logX: spansFactor(reaching, 30),
    entries,
    rows,
    reference: claimed.size === 1 && value !== null ? { value, name: 'claimed' } : null,
    note: missingIn(rows),
  };
}

export function matrixOf(found: Findings, rows: Measurement[]): MatrixPlot {
  const first = rows[0] as Measurement;
  const values = rows.flatMap((m) => (m.value === null ? [] : [m.value]));
  const quantity = asWritten(first.quantity),
    unit = first.unit === '' || first.unit === '1' ? '' : ` [${first.unit}]`;
  return {
    kind: 'matrix',
    id: slug(found.experiment, first.quantity),
    experiment: found.experiment,
    title: `${quantity}${unit}`,
    valueTitle: quantity + unit,
    schemes: found.schemes.filter((name) => rows.some((m) => m.scheme === name)),
    columns: [...new Set(rows.map((m) => m.observable))],
    log: spansFactor(values, 3),
    entries: rows
      .filter((m) => m.value !== null || m.low !== null || m.high !== null)
      .map((row) => ({ scheme: row.scheme, column: row.observable, row })),
    rows,
    note: '≥: nothing that was tried lies beyond. <: smaller than all that was tried.',
  };
}

// The plots of one experiment, found from the shape of its measurements: each row is claimed by the first that fits,
// and what none of them wants stands in the table of the section.
import type { Measurement, Results } from '../data';
import { grouped } from '../order';
import { costPlots } from './cost';
import { comparisonOf, curvePlots, matrixOf } from './curves';
import { fieldMaps } from './field';
import { hasAbscissa, type Findings } from './findings';
import type { Plot } from './model';
import { placePlots } from './places';

export interface Gathered {
  plots: Plot[];
  facts: Measurement[]; // known of the scene itself
  settings: Measurement[]; // known of a condition, without a scheme
  rest: Measurement[]; // in the table only
}

export function gather(
  r: Results,
  experiment: string,
  schemes: readonly string[],
  rows: Measurement[],
  earlier: Measurement[] | null = null,
): Gathered {
  const found: Findings = {
    experiment,
    schemes,
    rows,
    earlier,
    fits: r.fits.filter((f) => f.experiment === experiment),
    verdicts: r.verdicts.filter((v) => v.experiment === experiment),
  };
  const plots: Plot[] = [];
  for (const collect of [fieldMaps, costPlots, curvePlots, placePlots, alone]) plots.push(...collect(found));
  const schemeless = found.rows.filter((m) => m.scheme === '' && !hasAbscissa(m));
  const facts = schemeless.filter((m) => m.observable === '');
  const settings = schemeless.filter((m) => m.observable !== '' && m.value !== null);
  const placed = new Set([...facts, ...settings]);
  return { plots: named(plots), facts, settings, rest: found.rows.filter((m) => !placed.has(m)) };
}

/** Numbers of a scheme that belong to no step size: beside each other, or schemes × conditions. */
function alone(found: Findings): Plot[] {
  const plots: Plot[] = [],
    taken = new Set<Measurement>();
  const own = found.rows.filter((m) => m.scheme !== '' && !hasAbscissa(m));
  for (const rows of grouped(own, (m) => m.quantity).values()) {
    if (!rows.some((m) => m.value !== null || m.high !== null || m.low !== null)) continue;
    const conditions = new Set(rows.map((m) => m.observable)).size;
    plots.push(conditions > 1 ? matrixOf(found, rows) : comparisonOf(found, rows));
    for (const m of rows) taken.add(m);
  }
  found.rows = found.rows.filter((m) => !taken.has(m));
  return plots;
}

function named(plots: Plot[]): Plot[] {
  const known = new Map<string, number>();
  for (const plot of plots) {
    const count = (known.get(plot.id) ?? 0) + 1;
    known.set(plot.id, count);
    if (count > 1) plot.id += `.${count}`;
  }
  return plots;
}

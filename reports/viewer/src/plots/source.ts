// SPDX-License-Identifier: Apache-2.0
// The rows of an experiment, found by the series that they belong to.
import { valueAt } from '../coordinates';
import type { Fit, Measurement, PlotDescription, Series } from '../data';
import { grouped } from '../order';

const keyOf = (s: Series): string => JSON.stringify([s.experiment, s.scheme, s.quantity, s.observable, s.over]);

export class Source {
  private readonly bySeries: Map<string, Measurement[]>;
  private readonly fits: Map<string, Fit[]>;
  private readonly place = new Map<Measurement, number>();

  constructor(rows: Measurement[], fits: Fit[]) {
    this.bySeries = grouped(rows, keyOf);
    this.fits = grouped(fits, keyOf);
    rows.forEach((m, i) => this.place.set(m, i));
  }

  of(series: Series): Measurement[] {
    return this.bySeries.get(keyOf(series)) ?? [];
  }

  /** Those that have the coordinates which are the axes of the plot. */
  on(plot: PlotDescription, series: Series): Measurement[] {
    const axes = [plot.x, plot.y].filter((name) => name !== '');
    return this.of(series).filter((m) => axes.every((name) => valueAt(m, name) !== null));
  }

  /** The fitted power law that can be drawn. */
  fitOf(series: Series): Fit | null {
    return this.fits.get(keyOf(series))?.find((f) => f.order !== null && (f.prefactor ?? 0) > 0) ?? null;
  }

  /** Each once, in the order of the results. */
  inOrder(rows: Measurement[]): Measurement[] {
    const place = (m: Measurement): number => this.place.get(m) ?? 0;
    return [...new Set(rows)].sort((a, b) => place(a) - place(b));
  }
}

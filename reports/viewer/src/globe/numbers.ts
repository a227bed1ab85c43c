// SPDX-License-Identifier: Apache-2.0
// The densities as names, as a file and as a table.
import { rowsToCsv } from '../csv';
import type { Density } from '../data';
import { h } from '../dom';
import { exact, shown } from '../numbers';
import { table } from '../page/tables';

export function titleOf(d: Density): string {
  const time = d.time === null || d.name.includes('t = ') ? '' : `t = ${d.time}`;
  return [[d.name, time].filter((part) => part !== '').join(', ') || 'density', d.scheme]
    .filter((part) => part !== '')
    .join(' · ');
}

/** Every bin of every density, with its edges. */
export function densitiesCsv(densities: Density[]): string {
  const rows = densities.flatMap((d) =>
    d.values.map((value, i) => {
      const row = Math.floor(i / d.longitudes),
        column = i % d.longitudes;
      return [
        d.experiment,
        d.scheme,
        d.name,
        d.time,
        -1 + (2 * row) / d.heights,
        -1 + (2 * (row + 1)) / d.heights,
        -Math.PI + (2 * Math.PI * column) / d.longitudes,
        -Math.PI + (2 * Math.PI * (column + 1)) / d.longitudes,
        value,
      ];
    }),
  );
  return rowsToCsv(
    ['experiment', 'scheme', 'name', 'time', 'z_low', 'z_high', 'longitude_low', 'longitude_high', 'density'],
    rows,
  );
}

export function densityTable(densities: Density[]): HTMLElement {
  const range = (d: Density, pick: (...values: number[]) => number): number =>
    d.values.reduce<number>((a, v) => (v === null ? a : pick(a, v)), d.values[0] ?? 0);
  return h(
    'details',
    { class: 'behind' },
    h('summary', {}, `The ${densities.length} densities in numbers`),
    table(
      'densities',
      [
        { name: 'density' },
        { name: 'time', kind: 'n' },
        { name: 'bins' },
        { name: 'least', kind: 'n' },
        { name: 'greatest', kind: 'n' },
        { name: 'empty bins', kind: 'n' },
      ],
      densities.map((d) => ({
        cells: [
          titleOf(d),
          exact(d.time),
          `${d.longitudes} × ${d.heights}`,
          shown(range(d, Math.min)),
          shown(range(d, Math.max)),
          d.values.filter((v) => v === 0).length,
        ],
      })),
    ),
  );
}

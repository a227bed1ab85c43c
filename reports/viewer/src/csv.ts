// SPDX-License-Identifier: Apache-2.0
// Measurements as CSV (RFC 4180): every number with all its digits.
import type { Measurement } from './data';

/** Those of measurements.csv. */
export const columns = [
  'experiment',
  'scheme',
  'quantity',
  'observable',
  'dt',
  'value',
  'low',
  'high',
  'unit',
  'method',
  'at',
  'status',
  'used',
] as const;

/** Text that a spreadsheet would take for a formula is kept from being one. */
function field(value: string | number | boolean | null): string {
  if (value === null) return '';
  if (typeof value !== 'string') return String(value);
  const text = /^[=+\-@\t\r]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

export const rowsToCsv = (head: string[], rows: (string | number | boolean | null)[][]): string =>
  [head, ...rows].map((row) => row.map(field).join(',')).join('\r\n') + '\r\n';

/** "theta=8; dt=0.125" */
const placeIn = (m: Measurement): string => m.at.map((c) => `${c.name}=${c.value}`).join('; ');
const cellsOf = (m: Measurement) => columns.map((name) => (name === 'at' ? placeIn(m) : m[name]));

/** With the rows of an earlier run, a last column says whose each row is. */
export const csvOf = (rows: Measurement[], earlier: Measurement[] | null = null): string =>
  earlier === null
    ? rowsToCsv([...columns], rows.map(cellsOf))
    : rowsToCsv(
        [...columns, 'run'],
        [...rows.map((m) => [...cellsOf(m), 'this']), ...earlier.map((m) => [...cellsOf(m), 'earlier'])],
      );

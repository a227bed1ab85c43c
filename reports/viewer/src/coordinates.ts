// SPDX-License-Identifier: Apache-2.0
// Where a number was measured, in words.
import type { Coordinate, Measurement } from './data';
import { asWritten, exact } from './numbers';

export const valueAt = (m: Measurement, name: string): number | null =>
  m.at.find((c) => c.name === name)?.value ?? null;

export const textOf = (at: Coordinate[]): string =>
  at.map((c) => `${asWritten(c.name)} = ${exact(c.value)}`).join(', ');

/** The scene that was tried: by its name, or by its place. */
export const caseOf = (m: Measurement, conditions: string[]): string =>
  m.observable || textOf(m.at.filter((c) => conditions.includes(c.name)));

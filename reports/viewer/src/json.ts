// SPDX-License-Identifier: Apache-2.0
// JSON as it comes: whatever is not of the wanted kind is nothing.

export type Json = Record<string, unknown>;

export const isObject = (x: unknown): x is Json => typeof x === 'object' && x !== null && !Array.isArray(x);
export const text = (x: unknown): string =>
  typeof x === 'string' ? x : x === undefined || x === null ? '' : String(x);
export const number = (x: unknown): number | null => (typeof x === 'number' && Number.isFinite(x) ? x : null);
export const numbers = (x: unknown): number[] =>
  Array.isArray(x) ? x.map(number).filter((n): n is number => n !== null) : [];
export const records = (value: unknown): Json[] => (Array.isArray(value) ? value.filter(isObject) : []);

/** Throws an Error of one line where there is no object. */
export function parsed(source: string): Json {
  let document: unknown;
  try {
    document = JSON.parse(source);
  } catch (error) {
    const what = error instanceof Error ? error.message.replace(/\s+/g, ' ').slice(0, 160) : '';
    throw new Error(`These results cannot be read: not JSON, or cut short (${source.length} characters; ${what}).`);
  }
  if (!isObject(document)) throw new Error('These results cannot be read: JSON, but not an object.');
  return document;
}

// SPDX-License-Identifier: Apache-2.0
// Reads results.json tolerantly, so that an older or a partial file is shown with what it has.
import type { Density, Results, Scene } from './data';
import { isObject, number, numbers, parsed, text } from './json';
import { list } from './read_lists';
import { plotsOf } from './read_plots';

export const knownVersion = 2;

function rowsOf(value: unknown): number[][] {
  if (!Array.isArray(value)) return [numbers([value])];
  return value.some(Array.isArray) ? value.map(numbers) : [numbers(value)];
}

/** The key under which every system has its strength of dissipation. */
const dissipationKey = 'theta';

function sceneOf(x: unknown, missing: string[]): Scene {
  if (!isObject(x)) missing.push('no “scene”');
  const o = isObject(x) ? x : {};
  const known = new Set(['name', 'system', dissipationKey, 'sigma', 'momentum', 'horizon', 'steps']);
  return {
    name: text(o.name),
    system: text(o.system),
    parameters: Object.entries(o)
      .filter(([name]) => !known.has(name))
      .map(([name, value]) => ({
        name,
        ...(typeof value === 'string' ? { rows: [], word: value } : { rows: rowsOf(value), word: '' }),
      })),
    dissipation: number(o[dissipationKey]),
    sigma: Array.isArray(o.sigma) ? o.sigma.map(numbers) : [],
    momentum: numbers(o.momentum),
    horizon: number(o.horizon),
    steps: numbers(o.steps),
  };
}

/** Whole numbers of 64 bits do not survive a double: the seed is taken from the text. */
function provenanceOf(x: unknown, source: string, missing: string[]): Record<string, string> {
  if (!isObject(x)) missing.push('no “provenance”');
  const facts = Object.fromEntries(Object.entries(isObject(x) ? x : {}).map(([key, value]) => [key, text(value)]));
  const seed = /"provenance"\s*:\s*\{[^{}]*"seed"\s*:\s*(\d+)/.exec(source)?.[1];
  if (seed !== undefined) facts.seed = seed;
  return facts;
}

/** Throws an Error of one line where there is nothing to show. */
export function readResults(source: string): Results {
  const document = parsed(source);
  const missing: string[] = [];
  const schema = isObject(document.schema) ? document.schema : {};
  const version = number(schema.version);
  if (version !== knownVersion)
    missing.push(
      version === null
        ? 'no “schema” with a version'
        : `schema version ${version}, where this page knows ${knownVersion}`,
    );
  const counters = isObject(document.counters) ? document.counters : {};
  const counted = Object.entries(counters).map(([key, value]) => [key, number(value) ?? 0]);
  return {
    schema: { name: text(schema.name), version },
    provenance: provenanceOf(document.provenance, source, missing),
    scene: sceneOf(document.scene, missing),
    schemes: list(document, 'schemes', missing),
    experiments: list(document, 'experiments', missing),
    measurements: list(document, 'measurements', missing),
    fits: list(document, 'fits', missing),
    verdicts: list(document, 'verdicts', missing),
    plots: plotsOf(document, missing),
    skipped: list(document, 'skipped', missing),
    savings: list(document, 'savings', missing),
    reused: list(document, 'reused', missing),
    densities: list(document, 'densities', missing).filter((d) => whole(d, missing)),
    counters: Object.fromEntries(counted) as Record<string, number>,
    profile: list(document, 'profile', missing),
    toCome: Array.isArray(document.to_come) ? document.to_come.map(text) : [],
    missing,
  };
}

function whole(d: Density, missing: string[]): boolean {
  const bins = d.longitudes * d.heights;
  const good = Number.isInteger(bins) && bins > 0 && d.values.length === bins;
  if (!good) missing.push(`density “${d.name}”: ${d.values.length} values for ${d.longitudes} × ${d.heights} bins`);
  return good;
}

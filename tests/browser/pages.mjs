// SPDX-License-Identifier: Apache-2.0
// Pages to look at: the committed template with results in it.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const folder = join(here, '../../reports/viewer');
export const viewer = join(folder, 'package.json');

export const template = readFileSync(join(folder, 'dist/report.html'), 'utf8');
/** Kept where a test failed: what the runner does at the end, known only then, comes before what is asked for here. */
export const scratch = mkdtempSync(join(tmpdir(), 'polhode-browser-'));
before(() => process.on('exit', () => process.exitCode || rmSync(scratch, { recursive: true })));

/** As html.cpp does it; `earlier` as texts of JSON. */
export function fill(json, name, earlier = { before: '', comparison: '' }) {
  const packed = (text) => (text === '' ? '' : deflateSync(text).toString('base64')),
    escaped = name.replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);
  return template
    .replace('@polhode-title@', () => `${escaped} · polhode`)
    .replace('@polhode-results@', () => packed(json))
    .replace('@polhode-before@', () => packed(earlier.before))
    .replace('@polhode-comparison@', () => packed(earlier.comparison));
}

/** Writes the page and gives its address in the file system. */
export function pageOf(results, label) {
  const json = typeof results === 'string' ? results : JSON.stringify(results);
  const name = typeof results === 'string' ? label : String(results.scene?.name ?? label);
  const path = join(scratch, `${label}.html`);
  writeFileSync(path, fill(json, name));
  return pathToFileURL(path).href;
}

/** Two densities: one smooth, one with a thin fold of high density and empty bins. */
export function densities(experiment = 'attractor') {
  const longitudes = 128,
    heights = 64;
  const made = (name, time, at) => {
    const values = Array.from({ length: longitudes * heights }, (_, i) => {
      const z = (2 * Math.floor(i / longitudes) + 1) / heights - 1,
        longitude = (2 * Math.PI * ((i % longitudes) + 0.5)) / longitudes - Math.PI;
      return at(Math.sqrt(1 - z * z) * Math.cos(longitude), Math.sqrt(1 - z * z) * Math.sin(longitude), z);
    });
    const mean = values.reduce((a, b) => a + b) / values.length;
    return { experiment, scheme: 'strang', name, time, longitudes, heights, values: values.map((v) => v / mean) };
  };
  const fold = (x, y, z) => Math.exp(-60 * (y - 0.5 * Math.sin(3 * z) - 0.3 * x * x) ** 2);
  return [
    made('common noise, t = 0', 0, () => 1),
    made('common noise, t = 12.5', 12.5, (x, y, z) => 0.05 + fold(x, y, z)),
    made('common noise, t = 50', 50, (x, y, z) =>
      fold(x, y, z) < 0.02 ? 0 : fold(x, y, z) ** 3 + 0.5 * fold(y, z, x) ** 4,
    ),
    made('Gibbs', null, (x, y, z) => Math.exp((-4 * (x * x + (y * y) / 2 + (z * z) / 3)) / 2)),
  ];
}

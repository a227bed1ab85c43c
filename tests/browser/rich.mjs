// SPDX-License-Identifier: Apache-2.0
// A report with plots of every kind, and densities.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { densities, scratch } from './pages.mjs';

/** A short run of the scene `paper`; POLHODE_RESULTS names a results.json to look at instead. */
export function richResults(polhode) {
  const options = ['--effort', 'quick', '--experiments', 'casimir,strong,energy,stability,work_precision,lyapunov'];
  const run = ['verify', 'paper', ...options, '--schemes', 'heun,magnus', '--no-cache', '--format', 'json'];
  const given = process.env.POLHODE_RESULTS;
  const text = given
    ? readFileSync(given)
    : execFileSync(polhode, [...run, '--out', join(scratch, 'paper')], {
        maxBuffer: 1e9,
        stdio: ['ignore', 'pipe', 'ignore'],
      });
  return { ...JSON.parse(text), densities: densities() };
}

// SPDX-License-Identifier: Apache-2.0
// From density to colour: viridis (perceptually even, readable without red or green), logarithmic where it must be.
import type { Density } from '../data';

type Rgb = [number, number, number];

// Fit of matplotlib's viridis by polynomials of degree six (M. Zucker, public domain).
const terms: Rgb[] = [
  [0.2777273272, 0.0054073445, 0.3340998053],
  [0.1050930431, 1.4046135298, 1.3845901627],
  [-0.3308618287, 0.2148475595, 0.095095163],
  [-4.6342304983, -5.7991009734, -19.3324409563],
  [6.2282699333, 14.1799333668, 56.6905526007],
  [4.7763849977, -13.7451453774, -65.3530326334],
  [-5.4354558559, 4.645852612, 26.3124352495],
];

/** Share 0 to 1 as 0 to 255. */
export function viridis(share: number): Rgb {
  const t = Math.min(1, Math.max(0, share));
  return [0, 1, 2].map((i) =>
    Math.round(
      255 *
        Math.min(
          1,
          Math.max(
            0,
            terms.reduceRight((sum, c) => sum * t + (c[i] as number), 0),
          ),
        ),
    ),
  ) as Rgb;
}

/** The colours from low to high, in so many steps. */
export const ramp = (steps = 24): string[] =>
  Array.from({ length: steps }, (_, i) => `rgb(${viridis((i + 0.5) / steps).join(' ')})`);

export interface Scale {
  log: boolean;
  low: number;
  high: number;
  share(value: number | null): number;
  at(share: number): number;
}

/** One scale for all snapshots, at most four decades deep. */
export function scaleOver(densities: Density[]): Scale {
  let low = Infinity,
    high = 0;
  for (const d of densities)
    for (const v of d.values) {
      if (v === null || v <= 0) continue;
      if (v < low) low = v;
      if (v > high) high = v;
    }
  if (low > high) [low, high] = [0, 1];
  const log = low > 0 && high > 20 * low;
  if (log) low = Math.max(low, high * 1e-4);
  else low = 0;
  const span = log ? Math.log(high / low) : high - low || 1;
  return {
    log,
    low,
    high,
    share: (v) => (v === null || v <= low ? 0 : Math.min(1, log ? Math.log(v / low) / span : (v - low) / span)),
    at: (share) => (log ? low * Math.exp(share * span) : low + share * span),
  };
}

/** One pixel a bin, rows from z = -1 up. */
export function coloured(d: Density, scale: Scale): Uint8ClampedArray {
  const pixels = new Uint8ClampedArray(4 * d.values.length);
  d.values.forEach((v, i) => {
    pixels.set(v === null ? [128, 128, 128] : viridis(scale.share(v)), 4 * i);
    pixels[4 * i + 3] = 255;
  });
  return pixels;
}

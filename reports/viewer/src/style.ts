// SPDX-License-Identifier: Apache-2.0
// How a scheme looks: a colour after Okabe and Ito, a marker and dashes, so that no difference rests on colour alone.
import type { Kind } from './data';
import type { Theme } from './state';

export interface Paper {
  ink: string;
  soft: string;
  line: string;
  grid: string;
  card: string;
  colours: string[];
  positive: string;
  negative: string;
  share: string;
}

export const papers: Record<Theme, Paper> = {
  light: {
    ink: '#1f2328',
    soft: '#57606a',
    line: '#8c959f',
    grid: '#e6e8eb',
    card: '#ffffff',
    colours: ['#0072b2', '#c8500a', '#00805c', '#b0508c', '#a87400', '#2f93c8', '#4a4f57'],
    positive: '#b7410e',
    negative: '#00569c',
    share: '#0b7d5f',
  },
  dark: {
    ink: '#e6e8eb',
    soft: '#a3abb5',
    line: '#6b7480',
    grid: '#2c323a',
    card: '#1a1e23',
    colours: ['#5aaeea', '#f08a4b', '#35bd95', '#e08dbd', '#e0ac3a', '#8fd0f5', '#c6ccd4'],
    positive: '#f08a4b',
    negative: '#5aaeea',
    share: '#35bd95',
  },
};

const shapes = [
  'circle',
  'rect',
  'triangle',
  'diamond',
  'path://M0 0 L10 0 L5 9 Z', // triangle, down
  'path://M3.5 0 L6.5 0 L6.5 3.5 L10 3.5 L10 6.5 L6.5 6.5 L6.5 10 L3.5 10 L3.5 6.5 L0 6.5 L0 3.5 L3.5 3.5 Z', // plus
  'path://M5 0 L10 3.8 L8.1 10 L1.9 10 L0 3.8 Z', // pentagon
  'path://M2 0 L5 3 L8 0 L10 2 L7 5 L10 8 L8 10 L5 7 L2 10 L0 8 L3 5 L0 2 Z', // cross
];
const outlines: Record<string, string> = {
  circle: 'M10 5 A5 5 0 1 1 0 5 A5 5 0 1 1 10 5 Z',
  rect: 'M.5 .5 L9.5 .5 L9.5 9.5 L.5 9.5 Z',
  triangle: 'M5 0 L10 9 L0 9 Z',
  diamond: 'M5 -.8 L10 5 L5 10.8 L0 5 Z',
};
const dashes: (number[] | 'solid')[] = ['solid', [7, 3], [2, 3], [8, 3, 2, 3]];

export interface Look {
  colour: string;
  symbol: string;
  outline: string;
  dash: number[] | 'solid';
}

/** The first seven differ in colour and marker, the next seven in another marker and in dashes. */
export function lookOf(index: number, paper: Paper): Look {
  const colours = paper.colours.length,
    round = Math.floor(index / colours);
  const symbol = shapes[(index + round) % shapes.length] as string;
  return {
    colour: paper.colours[index % colours] as string,
    symbol,
    outline: outlines[symbol] ?? symbol.slice('path://'.length),
    dash: dashes[round % dashes.length] as number[] | 'solid',
  };
}

/** Colours of the claims' verdicts are in the style sheet; words and symbols are always beside them. */
export const words: Record<Kind, string> = {
  holds: 'holds',
  refuted: 'refuted',
  inconclusive: 'inconclusive',
  'not tried': 'not tried',
  skipped: 'skipped',
};

function channels(colour: string): number[] {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
}

/** From one colour (share 0) to another (share 1). */
export function mixed(from: string, to: string, share: number): string {
  const a = channels(from),
    b = channels(to),
    s = Math.min(1, Math.max(0, share));
  return (
    '#' +
    a
      .map((x, i) =>
        Math.round(x + s * ((b[i] ?? 0) - x))
          .toString(16)
          .padStart(2, '0'),
      )
      .join('')
  );
}

/** Black or white, whichever reads better on this colour. */
export function inkOn(colour: string): string {
  const [r = 0, g = 0, b = 0] = channels(colour);
  return 0.299 * r + 0.587 * g + 0.114 * b > 140 ? '#1f2328' : '#ffffff';
}

// SPDX-License-Identifier: Apache-2.0
// Axes: logarithmic or linear, with ticks where a reader looks for them.
import { power, shown } from '../numbers';

export interface Axis {
  log: boolean;
  min: number;
  max: number; // in axis coordinates
  ticks: number[]; // likewise
  label(at: number): string;
  /** The axis coordinate of a value; null where a logarithm has none. */
  at(value: number): number | null;
}

/** The least and the greatest; infinities where there is none. However many: Math.min takes only so many arguments. */
export function extent(values: Iterable<number>): [number, number] {
  let least = Infinity,
    most = -Infinity;
  for (const v of values) {
    if (v < least) least = v;
    if (v > most) most = v;
  }
  return [least, most];
}

/** 1, 2 or 5 times a power of ten, at least `least`. */
function niceStep(least: number): number {
  const scale = 10 ** Math.floor(Math.log10(least)),
    share = least / scale;
  return scale * (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10);
}

function linearTicks(min: number, max: number, wanted: number): number[] {
  const step = niceStep((max - min) / wanted),
    ticks: number[] = [];
  if (!(step > 0) || !Number.isFinite(step)) return [min, max];
  for (let k = Math.ceil(min / step - 1e-9); k * step <= max * (1 + 1e-12) + 1e-12 * step && ticks.length < 50; ++k)
    ticks.push(Number((k * step).toPrecision(12)));
  return ticks;
}

function logTicks(min: number, max: number, wanted: number): number[] {
  const decades = max - min;
  if (decades >= 3.2 || (decades >= 2.2 && wanted < 7)) {
    const step = Math.max(1, Math.ceil(decades / wanted));
    const ticks: number[] = [];
    for (let k = Math.ceil(min - 1e-9); k <= max + 1e-9; ++k) if (k % step === 0) ticks.push(k);
    return ticks;
  }
  const parts = decades >= 1.1 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  const ticks: number[] = [];
  for (let k = Math.floor(min); k <= max; ++k)
    for (const part of parts) {
      const at = k + Math.log10(part);
      if (at >= min - 1e-9 && at <= max + 1e-9) ticks.push(at);
    }
  return ticks.length >= 2
    ? ticks
    : linearTicks(10 ** min, 10 ** max, wanted)
        .filter((t) => t > 0)
        .map(Math.log10);
}

/** Plain numbers as long as all of them are short. */
function logLabels(ticks: number[]): (at: number) => string {
  const plain = ticks.every((at) => at > -3.5 && at < 3.5);
  return (at) => logLabel(at, plain);
}

function logLabel(at: number, plain: boolean): string {
  const value = 10 ** at,
    exponent = Math.round(at);
  if (Math.abs(at - exponent) < 1e-9) return plain || exponent === 0 ? shown(value) : power('10', exponent);
  const below = Math.floor(at);
  return below >= -4 && below <= 4 ? shown(value, 3) : `${shown(10 ** (at - below), 2)}·${power('10', below)}`;
}

/** Over values that are finite, of which a logarithm can show the positive ones only. */
export function axisOver(values: number[], log: boolean, room = 0.06, wanted = 7): Axis {
  const at = log ? (v: number) => (v > 0 ? Math.log10(v) : null) : (v: number) => v;
  let [min, max] = extent(values.flatMap((v) => at(v) ?? []).filter(Number.isFinite));
  if (min > max) [min, max] = log ? [-1, 0] : [0, 1];
  let pad = room * (max - min);
  if (!(pad > 0)) pad = log ? 0.5 : Math.abs(max) * 0.1 || 1;
  if (!Number.isFinite(max + pad - (min - pad))) {
    // near the end of the doubles
    pad = 0;
    if (min === max) min = max / 2;
    if (min > max) [min, max] = [max, min];
    if (!Number.isFinite(max - min)) [min, max] = [min / 4, max / 4];
  }
  min -= pad;
  max += pad;
  const ticks = log ? logTicks(min, max, wanted) : linearTicks(min, max, wanted);
  return { log, min, max, ticks, at, label: log ? logLabels(ticks) : (x) => shown(x) };
}

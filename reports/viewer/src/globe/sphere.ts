// SPDX-License-Identifier: Apache-2.0
// The sphere seen from a direction, the flat map of equal area, and the bins on it.
import type { Density } from '../data';

export type Vector = [number, number, number];
export interface View {
  longitude: number;
  latitude: number;
}

/** Right, up and towards the viewer, as directions in the body. */
export function frameOf({ longitude, latitude }: View): [Vector, Vector, Vector] {
  const [c, s, C, S] = [Math.cos(longitude), Math.sin(longitude), Math.cos(latitude), Math.sin(latitude)];
  return [
    [-s, c, 0],
    [-S * c, -S * s, C],
    [C * c, C * s, S],
  ];
}

/** The direction that is seen at (u, v) on the disc of radius one; null beside it. */
export function directionAt(view: View, u: number, v: number): Vector | null {
  const rest = 1 - u * u - v * v;
  if (rest < 0) return null;
  const [right, up, towards] = frameOf(view),
    w = Math.sqrt(rest);
  return [0, 1, 2].map((i) => u * (right[i] ?? 0) + v * (up[i] ?? 0) + w * (towards[i] ?? 0)) as Vector;
}

const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Where a direction is seen, and whether it lies on this side. */
export function seen(view: View, direction: Vector): { u: number; v: number; front: boolean } {
  const [right, up, towards] = frameOf(view);
  return { u: dot(right, direction), v: dot(up, direction), front: dot(towards, direction) > 0 };
}

/** The bin that holds a direction: rows of equal z from -1 up, longitudes from -pi. */
export function binOf(d: Density, [x, y, z]: Vector): number {
  const column = Math.floor(((Math.atan2(y, x) + Math.PI) / (2 * Math.PI)) * d.longitudes);
  const row = Math.floor(((z + 1) / 2) * d.heights);
  return Math.min(row, d.heights - 1) * d.longitudes + Math.min(column, d.longitudes - 1);
}

/** Mollweide's map of equal area: x and y within ±1 onto a direction; null outside of the ellipse. */
export function mollweideAt(x: number, y: number): Vector | null {
  const angle = Math.asin(Math.min(1, Math.max(-1, y))),
    reach = Math.cos(angle);
  if (Math.abs(x) > reach) return null;
  const z = (2 * angle + Math.sin(2 * angle)) / Math.PI,
    longitude = reach > 0 ? (Math.PI * x) / reach : 0;
  const flat = Math.sqrt(Math.max(0, 1 - z * z));
  return [flat * Math.cos(longitude), flat * Math.sin(longitude), z];
}

/** And back: where a latitude and a longitude stand on that map. */
export function mollweideOf(longitude: number, latitude: number): [number, number] {
  let angle = latitude;
  for (let i = 0; i < 30; ++i) {
    const slope = 2 + 2 * Math.cos(2 * angle);
    if (slope < 1e-12) break;
    angle -= (2 * angle + Math.sin(2 * angle) - Math.PI * Math.sin(latitude)) / slope;
  }
  return [(longitude / Math.PI) * Math.cos(angle), Math.sin(angle)];
}

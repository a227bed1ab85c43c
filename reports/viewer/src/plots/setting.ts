// SPDX-License-Identifier: Apache-2.0
// All that a drawing depends on beside its plot, and what the drawings share.
import type { Measurement } from '../data';
import { lookOf, type Look, type Paper } from '../style';
import { earlierPointsIn, pointsIn, schemesIn, type Plot } from './model';
import type { Axis } from './scale';

export interface Setting {
  paper: Paper;
  width: number;
  schemes: readonly string[];
  isolated: string | null;
  logX: boolean;
  logY: boolean;
  /** The earlier run is drawn, too, where there is one. */
  earlier: boolean;
  /** A picture that stands alone: with title and key, without motion. */
  standalone: boolean;
}

export const font = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";
/** Above this, points are drawn in bulk, without bars, on a canvas. */
export const manyPoints = 3000;

export const hasManyPoints = (plot: Plot): boolean => pointsIn(plot) + earlierPointsIn(plot) > manyPoints;

export function lookIn(s: Setting, scheme: string): Look {
  const index = s.schemes.indexOf(scheme);
  const look = lookOf(Math.max(0, index), s.paper);
  return index < 0 ? { ...look, colour: s.paper.ink } : look;
}

export const faded = (s: Setting, scheme: string): boolean =>
  s.isolated !== null && scheme !== '' && scheme !== s.isolated;

/** What a drawn item carries, so that a tooltip can name its numbers. */
export interface Item {
  rows: Measurement[];
  remark?: string;
  run?: string; // where there are two
}

export function axisOption(axis: Axis, title: string, s: Setting, side: 'x' | 'y') {
  const { paper } = s;
  return {
    type: 'value' as const,
    min: axis.min,
    max: axis.max,
    name: title,
    nameLocation: 'middle' as const,
    nameGap: side === 'x' ? 30 : 52,
    nameTextStyle: { color: paper.soft, fontSize: 12.5, fontFamily: font },
    axisLine: { show: true, onZero: false, lineStyle: { color: paper.line } },
    axisTick: { show: true, customValues: axis.ticks, lineStyle: { color: paper.line } },
    axisLabel: {
      customValues: axis.ticks,
      formatter: (at: number) => axis.label(at),
      color: paper.ink,
      fontSize: 12,
      fontFamily: font,
      hideOverlap: true,
    },
    splitLine: { show: true, lineStyle: { color: paper.grid } },
  };
}

/** Room for title and key where a picture stands alone. */
export function keyRows(plot: Plot, s: Setting): number {
  if (!s.standalone || plot.kind !== 'curve') return 0;
  const schemes = schemesIn(plot);
  const longest = Math.max(6, ...schemes.map((name) => Math.min(40, name.length)));
  return Math.ceil(schemes.length / Math.max(1, Math.floor((s.width - 20) / (46 + 7.2 * longest))));
}

// SPDX-License-Identifier: Apache-2.0
// From a plot to what ECharts is told.
import type { Option } from './charts';
import { comparisonOption } from './draw_comparison';
import { curveOption } from './draw_curve';
import { mapOption } from './draw_map';
import { matrixOption } from './draw_matrix';
import { mapHeight } from './map_frame';
import { earlierPointsIn, type Plot } from './model';
import { font, hasManyPoints, keyRows, type Item, type Setting } from './setting';
import { tooltipOf } from './tooltip';

/** What every drawing shares: no motion, tooltips by item, and the key of a picture that stands alone. */
export function frame(plot: Plot, s: Setting): Option {
  return {
    animation: false,
    backgroundColor: s.standalone ? s.paper.card : 'transparent',
    textStyle: { fontFamily: font, color: s.paper.ink },
    ...(s.standalone
      ? {
          title: {
            text: plot.title + (s.earlier && earlierPointsIn(plot) > 0 ? ' (faint: the earlier run)' : ''),
            left: 12,
            top: 10,
            textStyle: {
              fontSize: 15,
              fontWeight: 600,
              color: s.paper.ink,
              fontFamily: font,
              width: s.width - 24,
              overflow: 'break',
            },
          },
        }
      : {}),
    tooltip: {
      trigger: 'item',
      confine: true,
      transitionDuration: 0,
      backgroundColor: s.paper.card,
      borderColor: s.paper.line,
      padding: [8, 10],
      textStyle: { color: s.paper.ink, fontSize: 13, fontFamily: font },
      formatter: (given: unknown) => {
        const { data } = given as { data?: { item?: Item } };
        return data?.item ? tooltipOf(data.item.rows, data.item.remark, data.item.run) : '';
      },
    },
  } as Option;
}

export function heightOf(plot: Plot, s: Setting): number {
  const title = s.standalone ? 34 : 0;
  switch (plot.kind) {
    case 'curve':
      return title + 22 * keyRows(plot, s) + (s.width < 420 ? 300 : 380);
    case 'comparison':
      return title + 76 + 22 * Math.max(1, plot.entries.length);
    case 'matrix':
      return title + (plot.columns.length <= 6 ? 46 : 120) + 26 * plot.schemes.length;
    case 'map':
      return title + mapHeight(plot, s);
  }
}

export function optionOf(plot: Plot, s: Setting): Option {
  const shared = frame(plot, s);
  switch (plot.kind) {
    case 'curve':
      return { ...shared, ...curveOption(plot, s, hasManyPoints(plot)) };
    case 'comparison':
      return { ...shared, ...comparisonOption(plot, s) };
    case 'matrix':
      return { ...shared, ...matrixOption(plot, s) };
    case 'map':
      return { ...shared, ...mapOption(plot, s) };
  }
}

// SPDX-License-Identifier: Apache-2.0
// Arrow keys in a chart: along a line of points, and from one line to the next.
import type { Chart } from './charts';

/** A listener that shows the tooltip of one point after the other. */
export function walker(chartNow: () => Chart | null): (event: KeyboardEvent) => void {
  let spot: [number, number] | null = null; // series and point
  return (event) => {
    const chart = chartNow();
    const along = { ArrowRight: 1, ArrowLeft: -1 }[event.key],
      across = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === 'Escape') chart?.dispatchAction({ type: 'hideTip' });
    if ((along === undefined && across === undefined) || !chart) return;
    event.preventDefault();
    const option = chart.getOption() as { series: { data: { item?: unknown }[]; silent?: boolean }[] };
    const lines = option.series
      .map((s, index) => ({ index, size: s.silent ? 0 : s.data.filter((d) => d.item).length }))
      .filter((line) => line.size > 0);
    const before = lines.findIndex((line) => line.index === spot?.[0]);
    const line = lines[(Math.max(0, before) + (spot ? (across ?? 0) : 0) + lines.length) % lines.length];
    if (!line) return;
    const point = spot ? spot[1] + (along ?? 0) : 0;
    spot = [line.index, (point + line.size) % line.size];
    chart.dispatchAction({ type: 'showTip', seriesIndex: spot[0], dataIndex: spot[1] });
  };
}

// SPDX-License-Identifier: Apache-2.0
// What is said of a plot in words: to who cannot see it, and below it.
import { h, type Child } from '../dom';
import { earlierPointsIn, pointsIn, schemesIn, type Plot } from './model';
import { hasManyPoints } from './setting';

export function spoken(plot: Plot): string {
  const schemes = schemesIn(plot).length;
  return (
    `${plot.title}: ${pointsIn(plot)} values${schemes > 0 ? ` of ${schemes} schemes` : ''}. ` +
    'Arrow keys go from point to point; the table below holds every number.'
  );
}

export function remarks(plot: Plot): Child {
  const parts: string[] = [];
  if (plot.kind === 'curve' && plot.hollow !== '') parts.push(`Hollow: ${plot.hollow}. `);
  if (plot.kind === 'curve' && plot.lines.some((l) => l.fit))
    parts.push('Wide line: the fitted power law; its wedge is the interval of the order. ');
  if (earlierPointsIn(plot) > 0) parts.push('Faint: the earlier run. ');
  if (plot.kind === 'curve' && hasManyPoints(plot)) parts.push(`${pointsIn(plot)} points: drawn without bars. `);
  parts.push(plot.note);
  return parts.join('') !== '' && h('p', { class: 'note' }, ...parts);
}

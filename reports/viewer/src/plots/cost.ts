// Cost against error, with the Pareto front, and what each target accuracy costs.
import type { Measurement } from '../data';
import { asWritten, slug } from '../numbers';
import { grouped } from '../order';
import type { Findings } from './findings';
import type { CurvePlot, Line, Plot, Point } from './model';

const counts = ['steps_per_time', 'normals_per_time'];
const at = (m: Measurement): string => JSON.stringify([m.observable, m.scheme, m.dt]);

/** "strong 1e-02" */
export function targetOf(m: Measurement): { goal: string; accuracy: number } | null {
  const found = /^(.*) (\d[\d.]*(?:e[-+]?\d+)?)$/i.exec(m.observable);
  const accuracy = Number(found?.[2]);
  return found && accuracy > 0 ? { goal: found[1] ?? '', accuracy } : null;
}

export function costPlots(found: Findings): Plot[] {
  const plots = [...frontPlots(found), ...reachPlots(found)];
  const taken = new Set(plots.flatMap((plot) => plot.rows));
  found.rows = found.rows.filter((m) => !taken.has(m));
  return plots;
}

function linesBy(found: Findings, rows: Measurement[], pointsOf: (rows: Measurement[]) => Point[]): Line[] {
  const byScheme = grouped(rows, (m) => m.scheme);
  return [...new Set([...found.schemes, ...byScheme.keys()])].flatMap((scheme) => {
    const points = pointsOf(byScheme.get(scheme) ?? []).sort((a, b) => a.x - b.x);
    return points.length === 0 ? [] : [{ scheme, points, fit: null }];
  });
}

const plain = { kind: 'curve' as const, logX: true, logY: true, slopes: [], levels: [], absolute: false };

function frontPlots(found: Findings): CurvePlot[] {
  const costs = new Map(found.rows.filter((m) => m.quantity === 'cost' && m.value !== null).map((m) => [at(m), m]));
  const errors = found.rows.filter((m) => m.quantity === 'error_at_cost' && m.value !== null && costs.has(at(m)));
  const counted = grouped(
    found.rows.filter((m) => counts.includes(m.quantity)),
    at,
  );
  return [...grouped(errors, (m) => m.observable).entries()].map(([goal, rows]) => {
    const pointsOf = (own: Measurement[]): Point[] =>
      own.map((error) => {
        const cost = costs.get(at(error)) as Measurement;
        return {
          x: error.value as number,
          y: cost.value ?? 0,
          low: cost.low,
          high: cost.high,
          xLow: error.low,
          xHigh: error.high,
          filled: cost.fitted,
          rows: [error, cost, ...(counted.get(at(error)) ?? [])],
        };
      });
    const lines = linesBy(found, rows, pointsOf),
      first = rows[0] as Measurement;
    const cost = costs.get(at(first)) as Measurement;
    const byTime: CurvePlot = {
      ...plain,
      id: slug(found.experiment, 'cost', goal),
      experiment: found.experiment,
      lines,
      front: true,
      title: `Cost against error: ${asWritten(goal)}`,
      xTitle: `${asWritten(goal)} error [${asWritten(first.unit)}]`,
      yTitle: `cost [${cost.unit}]`,
      hollow: 'not on the Pareto front of times',
      note: 'Lower left is better.',
      rows: lines.flatMap((l) => l.points.flatMap((p) => p.rows)),
    };
    return { ...byTime, others: counts.flatMap((quantity) => countedPlot(byTime, quantity)) };
  });
}

/** What no machine changes; the program knows the front of the times only, so there is none here. */
function countedPlot(byTime: CurvePlot, quantity: string): { name: string; plot: CurvePlot }[] {
  const pointsOf = (points: Point[]): Point[] =>
    points.flatMap((p) => {
      const counted = p.rows.find((m) => m.quantity === quantity && m.value !== null);
      if (!counted) return [];
      return [{ ...p, y: counted.value as number, low: counted.low, high: counted.high, filled: true }];
    });
  const lines = byTime.lines
    .map((l) => ({ ...l, points: pointsOf(l.points) }))
    .filter((l) => l.points.some((p) => p.y > 0));
  const unit = lines[0]?.points[0]?.rows.find((m) => m.quantity === quantity)?.unit ?? '';
  const plot = {
    ...byTime,
    lines,
    front: false,
    hollow: '',
    title: `${byTime.title}, in ${unit}`,
    yTitle: `cost [${unit}]`,
  };
  return lines.length === 0 ? [] : [{ name: quantity.split('_')[0] ?? quantity, plot }];
}

function reachPlots(found: Findings): CurvePlot[] {
  const rows = found.rows.filter((m) => ['cost_to_reach', 'cost_of_next'].includes(m.quantity) && targetOf(m));
  return [...grouped(rows, (m) => targetOf(m)?.goal ?? '').entries()].flatMap(([goal, all]) => {
    const reached = all.filter((m) => m.quantity === 'cost_to_reach' && m.value !== null);
    const next = new Map(all.filter((m) => m.quantity === 'cost_of_next').map((m) => [m.scheme + m.observable, m]));
    const pointsOf = (own: Measurement[]): Point[] =>
      own.map((m) => {
        const other = next.get(m.scheme + m.observable);
        return {
          x: targetOf(m)?.accuracy ?? 0,
          y: m.value as number,
          low: m.low,
          high: m.high,
          filled: m.fitted,
          rows: other ? [m, other] : [m],
        };
      });
    const first = reached[0];
    if (!first) return [];
    const failed = all.filter((m) => m.quantity === 'cost_to_reach' && m.value === null).length;
    return [
      {
        ...plain,
        id: slug(found.experiment, 'reach', goal),
        experiment: found.experiment,
        rows: all,
        lines: linesBy(found, reached, pointsOf),
        front: false,
        title: `Cost to reach an accuracy: ${asWritten(goal)}`,
        xTitle: `${asWritten(goal)} error to be reached`,
        yTitle: `cost [${first.unit}]`,
        hollow: 'not the cheapest',
        note: failed ? `${failed} targets are not reached at the steps that were measured.` : '',
      },
    ];
  });
}

// SPDX-License-Identifier: Apache-2.0
// One experiment: its question, its plots, its fits, its verdicts, and all that was measured.
import { caseOf } from '../coordinates';
import type { Density, Experiment, Measurement, PlotDescription, PlotKind, Results, Verdict } from '../data';
import { h, lazily, type Child } from '../dom';
import { Figure } from '../figure';
import { GlobeFigure } from '../globe/figure';
import { asWritten, prose, shown, shownCertain } from '../numbers';
import { symbols, tally } from '../order';
import { kindsByWeight } from '../data';
import { picked, rowsIn } from '../plots/pick';
import type { Source } from '../plots/source';
import { fitTable, measurementTable, orderTable, verdictTable } from './result_tables';
import { chip, table } from './tables';

const mostPlots = 60;

/** What can be put on paper. */
export interface Printable {
  print(): void;
  unprint(): void;
}

export interface Context {
  results: Results;
  schemes: readonly string[];
  measurements: Map<string, Measurement[]>;
  verdicts: Map<string, Verdict[]>;
  printables: Printable[];
  source: Source;
  /** Of the run that this one is held against. */
  before: Source | null;
}

function question(declared: Experiment | undefined): Child[] {
  if (!declared) return [];
  return [declared.question !== '' && h('p', { class: 'question' }, prose(declared.question))];
}

function notes(declared: Experiment | undefined): Child {
  if (!declared || declared.notes.length === 0) return false;
  return h(
    'details',
    { class: 'notes' },
    h('summary', {}, 'How it is measured'),
    h('ul', {}, ...declared.notes.map((note) => h('li', {}, prose(note)))),
  );
}

function facts(rows: Measurement[]): Child {
  if (rows.length === 0) return false;
  return h(
    'dl',
    { class: 'facts' },
    ...rows.map((m) =>
      h(
        'div',
        {},
        h('dt', {}, asWritten(m.quantity)),
        h(
          'dd',
          { title: m.value === null ? '' : String(m.value) },
          [m.value === null ? '' : shownCertain(m.value, m.low, m.high, m.unit), m.status === 'ok' ? '' : m.status]
            .filter((part) => part !== '')
            .join('; '),
        ),
      ),
    ),
  );
}

/** Conditions × quantities, known without a scheme. */
function settings(described: PlotDescription | undefined, source: Source): Child {
  if (!described) return false;
  const rows = rowsIn(described, source).filter((m) => m.value !== null),
    condition = (m: Measurement): string => caseOf(m, described.conditions);
  const quantities = [...new Set(rows.map((m) => m.quantity))],
    conditions = [...new Set(rows.map(condition))].slice(0, 500);
  return h(
    'details',
    {},
    h('summary', {}, `Known of the conditions: ${quantities.map(asWritten).join(', ')}`),
    table(
      'conditions',
      [{ name: 'condition' }, ...quantities.map((name) => ({ name: asWritten(name), kind: 'n' as const }))],
      conditions.map((one) => ({
        cells: [
          asWritten(one),
          ...quantities.map((name) =>
            shown(rows.find((m) => m.quantity === name && condition(m) === one)?.value ?? null),
          ),
        ],
      })),
    ),
  );
}

function standing(verdicts: Verdict[]): Child {
  const counts = tally(verdicts);
  return (
    verdicts.length > 0 &&
    h(
      'span',
      { class: 'standing' },
      ...kindsByWeight.filter((kind) => counts[kind] > 0).map((kind) => chip(kind, counts[kind])),
    )
  );
}

export function section(name: string, densities: Density[], context: Context): HTMLElement {
  const { results, schemes } = context,
    rows = context.measurements.get(name) ?? [],
    verdicts = context.verdicts.get(name) ?? [];
  const declared = results.experiments.find((e) => e.name === name),
    described = results.plots.filter((p) => p.experiment === name),
    tableOfKind = (kind: PlotKind): PlotDescription | undefined => described.find((p) => p.kind === kind);
  const plots = described.flatMap((p) => picked(p, context.source, context.before) ?? []),
    known = tableOfKind('facts');
  const figures = plots.slice(0, mostPlots).map((plot) => new Figure(plot, schemes));
  const globes = densities.length > 0 ? [new GlobeFigure(name, densities)] : [];
  context.printables.push(...globes, ...figures);
  const fits = results.fits.filter((f) => f.experiment === name),
    skips = results.skipped.filter((s) => s.experiment === name);
  const own = results.verdicts.filter((v) => v.experiment === name);
  const beside =
    figures.length === 1 &&
    fits.length > 0 &&
    fits.length <= 24 &&
    h('div', { class: 'plot' }, h('h3', {}, 'Orders'), orderTable(fits, own));
  const unsettled = verdicts.some((v) => v.verdict === 'refuted' || v.verdict === 'inconclusive');
  return h(
    'section',
    { class: 'experiment', id: `experiment.${name}` },
    h('h2', {}, asWritten(name), ' ', standing(verdicts)),
    ...question(declared),
    facts(known ? rowsIn(known, context.source) : []),
    h('div', { class: 'plots' }, ...globes.map((g) => g.element), ...figures.map((f) => f.element), beside),
    plots.length > mostPlots &&
      h(
        'p',
        { class: 'note' },
        `${plots.length - mostPlots} more plots are left out here; their numbers are in the table.`,
      ),
    settings(tableOfKind('conditions'), context.source),
    verdicts.length > 0 && lazily(`${verdicts.length} verdicts`, () => verdictTable(verdicts), { open: unsettled }),
    fits.length > 0 && lazily(`${fits.length} fits`, () => fitTable(fits, own)),
    rows.length > 0
      ? lazily(`${rows.length} measurement${rows.length === 1 ? '' : 's'}`, () => measurementTable(rows))
      : h('p', { class: 'note' }, densities.length > 0 ? '' : 'Nothing was measured here.'),
    ...skips.map((s) =>
      h('p', { class: 'note' }, `${symbols.skipped} Skipped for ${s.scheme || 'every scheme'}: ${s.reason}`),
    ),
    notes(declared),
  );
}

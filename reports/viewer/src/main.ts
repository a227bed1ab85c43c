// SPDX-License-Identifier: Apache-2.0
// The report: reads the results that the program put into the page, and builds the page from them.
import { readComparison, type Comparison } from './comparison';
import type { Measurement, Results } from './data';
import { h, type Child } from './dom';
import { asWritten } from './numbers';
import { byExperiment, experimentNames, schemeNames } from './order';
import { advice } from './page/advice';
import { bar } from './page/bar';
import { board } from './page/board';
import { changes } from './page/changes';
import { schemeTable } from './page/claims';
import { header } from './page/header';
import { leftOut } from './page/left_out';
import { profile, provenance } from './page/provenance';
import { section, type Context, type Printable } from './page/section';
import { Source } from './plots/source';
import { readResults } from './read';
import { followAddress } from './state';
import './styles/index.css';
import { canUnpack, unpacked } from './unpacked';

/** The run that this one is held against. */
interface Earlier {
  results: Results;
  comparison: Comparison;
}

/** What may be drawn behind this run: no timing that another machine has measured. */
function behind(earlier: Earlier | null): Measurement[] | null {
  if (!earlier) return null;
  const { results, comparison } = earlier;
  return comparison.timingsLeftOut === ''
    ? results.measurements
    : results.measurements.filter((m) => m.method !== 'timed');
}

function build(r: Results, earlier: Earlier | null): { page: Node[]; printables: Printable[]; schemes: string[] } {
  const schemes = schemeNames(r),
    experiments = experimentNames(r),
    printables: Printable[] = [],
    source = new Source(r.measurements, r.fits),
    drawnBehind = behind(earlier);
  const context: Context = {
    results: r,
    schemes,
    printables,
    measurements: byExperiment(r.measurements),
    verdicts: byExperiment(r.verdicts),
    source,
    before: drawnBehind && new Source(drawnBehind, []),
  };
  const densities = byExperiment(r.densities);
  const sections = experiments.map((name) => section(name, densities.get(name) ?? [], context));
  const choice = advice(r, source);
  const places: [string, string][] = [
    ...(earlier ? [['changes', 'What has changed'] as [string, string]] : []),
    ...(r.verdicts.length > 0 ? [['board', 'Claims'] as [string, string]] : []),
    ...(choice ? [['advice', 'Which one?'] as [string, string]] : []),
    ...experiments.map((name): [string, string] => [`experiment.${name}`, asWritten(name)]),
    ['left-out', 'Left out'],
    ['provenance', 'Provenance'],
  ];
  const first = board(r, schemes, experiments),
    claims = schemeTable(r),
    changed = earlier && changes(earlier.comparison, earlier.results, r);
  const parts = [header(r), changed, first, choice, ...sections, claims, leftOut(r), profile(r), provenance(r)].filter(
    (part): part is HTMLElement => part instanceof Node,
  );
  return { page: [bar(places, schemes), h('main', {}, ...parts)], printables, schemes };
}

/** On paper every plot is there, light, as a picture of its own. */
function preparePaper(printables: Printable[]): void {
  let onPaper = false;
  const turn = (paper: boolean): void => {
    if (paper === onPaper) return;
    onPaper = paper;
    for (const one of printables) paper ? one.print() : one.unprint();
  };
  addEventListener('beforeprint', () => turn(true));
  addEventListener('afterprint', () => turn(false));
  matchMedia('print').addEventListener('change', (event) => turn(event.matches));
}

/** In place of the report: why there is none. */
function fault(...said: Child[]): void {
  document.body.append(h('main', {}, h('p', { class: 'fault', role: 'alert' }, ...said)));
}

/** What is missing where a browser cannot unpack, and where it stands. */
function notUnpacked(isComparison: boolean): Child[] {
  const file = (name: string): HTMLElement => h('a', { href: name }, name);
  return [
    'The claims, plots and tables of this report are missing: they stand compressed in this file, and this browser ',
    'cannot unpack them (Chromium can from version 80 on, Safari from 16.4, Firefox from 113). ',
    ...(isComparison
      ? ['The same numbers are in the two results.json that were compared.']
      : [
          'The same results are beside it: ',
          file('report.md'),
          ' to be read, ',
          file('results.json'),
          ' for programs.',
        ]),
  ];
}

async function start(): Promise<void> {
  const source = (id: string): string => document.getElementById(id)?.textContent ?? '';
  if (!canUnpack()) {
    fault(...notUnpacked(source('before') !== ''));
    return;
  }
  let results: Results,
    earlier: Earlier | null = null;
  try {
    results = readResults(await unpacked(source('results')));
    if (source('before') !== '')
      earlier = {
        results: readResults(await unpacked(source('before'))),
        comparison: readComparison(await unpacked(source('comparison'))),
      };
  } catch (error) {
    fault(error instanceof Error ? error.message : String(error));
    return;
  }
  const { page, printables, schemes } = build(results, earlier);
  document.body.append(...page);
  preparePaper(printables);
  followAddress(schemes);
  addEventListener('hashchange', () => followAddress(schemes));
}

void start();

// SPDX-License-Identifier: Apache-2.0
// results.json as plain values.

export type Kind = 'holds' | 'refuted' | 'inconclusive' | 'not tried' | 'skipped';
export const kindsByWeight: readonly Kind[] = ['refuted', 'inconclusive', 'holds', 'not tried', 'skipped'];

export interface Coordinate {
  name: string;
  value: number | null;
  unit: string;
}
export interface Measurement {
  experiment: string;
  scheme: string;
  quantity: string;
  observable: string;
  dt: number | null; // one of its coordinates, as it is asked for often
  at: Coordinate[];
  over: string; // the coordinate that is the abscissa of its series
  value: number | null;
  low: number | null;
  high: number | null;
  unit: string;
  method: string;
  status: string;
  used: boolean; // in the fit of its series
}
export interface Fit {
  experiment: string;
  scheme: string;
  quantity: string;
  observable: string;
  over: string;
  order: number | null;
  low: number | null;
  high: number | null;
  prefactor: number | null;
  status: string;
  rule: string;
}
export interface Verdict {
  experiment: string;
  scheme: string;
  claim: string;
  expected: number | null;
  estimate: number | null;
  low: number | null;
  high: number | null;
  verdict: Kind;
  reason: string;
  evidence: Series[];
}
export interface Series {
  experiment: string;
  scheme: string;
  quantity: string;
  observable: string;
  over: string;
}
export const plotKinds = ['curve', 'front', 'reach', 'comparison', 'matrix', 'map', 'facts', 'conditions'] as const;
export type PlotKind = (typeof plotKinds)[number];
/** A measurement belongs to a line if it is of the series and has the coordinates that are the axes of the plot. */
export interface PlotLine {
  series: Series;
  across: Series | null; // of `front`: the errors; cost and error pair by their step size
  beside: Series[]; // told with the point of the same abscissa
  border: Series | null; // of `map`: measured at one of its coordinates
}
export interface PlotAlternative {
  name: string;
  title: string;
  yTitle: string;
  lines: PlotLine[];
}
/** What there is to see: the program says which plots there are, and of which series. Texts are as written in results. */
export interface PlotDescription {
  id: string;
  experiment: string;
  kind: PlotKind;
  title: string;
  note: string;
  of: string; // of `front` and `reach`: which error
  x: string; // the coordinates that are its axes
  y: string;
  conditions: string[]; // the coordinates that name a condition
  xTitle: string;
  yTitle: string;
  valueTitle: string;
  borderTitle: string;
  logX: boolean;
  logY: boolean;
  logValues: boolean;
  absoluteTitle: string; // not empty: there is y < 0, and a logarithm shows |y|
  diverging: boolean;
  borderAcross: boolean;
  hollow: string;
  slopes: number[];
  claimed: number | null;
  lines: PlotLine[];
  levels: Series[];
  others: PlotAlternative[];
}
export interface Experiment {
  name: string;
  question: string;
  notes: string[];
}
export interface Scheme {
  name: string;
  title: string;
  source: string;
  calculus: string;
  implicit: boolean;
  areas: boolean;
  claims: Record<string, number | boolean | null>;
  from: string; // the door of an integrator from elsewhere; of ours: none
  takes: string;
  measured: Record<string, number>; // orders that it does not claim
}
export interface Saved {
  normals_drawn: number;
  path_steps: number;
  kernels_run: number;
  cpu_seconds: number;
}
export interface Skip {
  experiment: string;
  scheme: string;
  reason: string;
  saved: Saved;
}
export interface Saving extends Skip {
  what: string;
}
export interface Reuse {
  experiment: string;
  scheme: string;
  computed: string;
  saved: Saved;
}
/** Density relative to the uniform one on bins of equal area: rows of equal z from -1 up, longitudes from -pi. */
export interface Density {
  experiment: string;
  scheme: string;
  name: string;
  time: number | null;
  longitudes: number;
  heights: number;
  values: (number | null)[];
}
/** A parameter of the scene's system: a number, a vector, a list of vectors, or a word. */
export interface Parameter {
  name: string;
  rows: number[][];
  word: string; // empty: numbers
}
export interface Scene {
  name: string;
  system: string;
  parameters: Parameter[]; // but dissipation and noise, which every system has
  dissipation: number | null;
  sigma: number[][];
  momentum: number[];
  horizon: number | null;
  steps: number[];
}
/** Processor time of an experiment by what was worked on: a scheme, "noise", or empty for all else. */
export interface Charge {
  experiment: string;
  scheme: string;
  cpuSeconds: number;
}
export interface Results {
  schema: { name: string; version: number | null };
  provenance: Record<string, string>;
  scene: Scene;
  schemes: Scheme[];
  experiments: Experiment[];
  measurements: Measurement[];
  fits: Fit[];
  verdicts: Verdict[];
  plots: PlotDescription[];
  skipped: Skip[];
  savings: Saving[];
  reused: Reuse[];
  densities: Density[];
  counters: Record<string, number>;
  profile: Charge[];
  /** Experiments that an unfinished run had before it. */
  toCome: string[];
  /** What the file lacks, in words. */
  missing: string[];
}

import type { Fit, Measurement, Verdict } from '../data';

/** What an experiment found, and what is taken away from it as plots claim their rows. */
export interface Findings {
  experiment: string;
  schemes: readonly string[];
  fits: Fit[];
  verdicts: Verdict[];
  rows: Measurement[];
  /** Of the run that this one is held against, if there is one. */
  earlier: Measurement[] | null;
}

export const hasAbscissa = (m: Measurement): boolean => m.dt !== null || m.steps !== null;

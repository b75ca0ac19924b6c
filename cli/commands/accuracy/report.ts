import type { Accuracy } from '../../../engine/index.ts';
import { GOOD_ENOUGH, type Measured, type WorkPrecision } from '../../../engine/work-precision/index.ts';
import type { AccuracyReport as AccuracyJson, Hold, TermsReport } from '../../../schema/index.ts';

/** The results of `accuracy` for a run of a level. */
export interface AccuracyReport {
  readonly file: string;
  /** Under which terms all this holds. */
  readonly terms: TermsReport;
  /** The level's name. */
  readonly level: string;
  /** The name of the run. */
  readonly run: string;
  readonly holds: readonly Hold[];
  readonly measured: WorkPrecision;
  /** The cheapest setting with the reference's outcome and an error below {@link GOOD_ENOUGH}. */
  readonly cheapest: Measured | null;
  /** The setting that the command line asks for. */
  readonly asked: Accuracy | null;
}

const methodJson = ({ accuracy, error, cost, outcome, time, sameVerdict }: Measured) => ({
  name: accuracy.name,
  integrator: accuracy.integrator,
  ...(accuracy.rate === null ? { tolerance: accuracy.tolerance } : { rate: accuracy.rate }),
  contact: accuracy.contact,
  error,
  cost: cost.minimum,
  medianCost: cost.median,
  outcome,
  time,
  sameVerdict,
});

/** The results of `accuracy` as JSON: errors in px, costs in microseconds per simulated second, times in s. */
export function accuracyJson({ level, terms, holds, measured, cheapest }: AccuracyReport): string {
  const { tolerance, outcome, time, floor } = measured.reference;
  const report: AccuracyJson = {
    version: 1,
    level,
    terms,
    holds: holds.map(([press, release]) => [press, release]),
    reference: { tolerance, outcome, time, floor },
    methods: measured.methods.map(methodJson),
    cheapest: { below: GOOD_ENOUGH, name: cheapest?.accuracy.name ?? null },
  };
  return `${JSON.stringify(report)}\n`;
}

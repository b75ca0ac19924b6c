import type { Command } from 'commander';
import { type AccuracyOptions, chooseAccuracy } from '../../accuracy-options.ts';
import { type AskedOptions, refuseLimitsWithoutSearch, settingsFor } from '../../check/index.ts';
import type { ConfigOptions } from '../../config-file.ts';
import type { Configuration } from '../../configuration.ts';
import { Failure } from '../../failure.ts';
import type { JobName } from '../../fleet/index.ts';
import { refuseUnused } from '../../unused-options.ts';

/** Options of the commands that shards run. */
export interface PlanOptions extends AccuracyOptions, ConfigOptions, AskedOptions {
  readonly maxWarnings?: number;
  readonly brief?: true;
}

/** What a plan says about its job. */
export interface JobOrder {
  readonly settings: Record<string, unknown>;
  readonly report: Record<string, unknown>;
}

/** Ticks of a search, unless others are given. */
const DEFAULT_EFFORT = 5_000_000;

/** What each command makes of the options. */
export const ORDERS: Readonly<
  Record<JobName, (options: PlanOptions, configuration: Configuration, command: Command) => JobOrder>
> = {
  check: checkOrder,
};

function checkOrder(options: PlanOptions, configuration: Configuration, command: Command): JobOrder {
  refuseLimitsWithoutSearch(options);
  refuseTime(options);
  refuseUnused(command, [{ option: '--seed', isUsed: options.solve === true, needs: '--solve' }]);
  const accuracy = chooseAccuracy(options, configuration);
  const effort = options.solve ? (options.effort ?? DEFAULT_EFFORT) : undefined;
  const { severity } = configuration;
  return {
    // what is tried must not depend on how many levels there are
    settings: {
      ...settingsFor({ ...options, effort }, configuration, Number.POSITIVE_INFINITY),
      accuracy,
      inFull: !options.brief,
    },
    report: { accuracy: accuracy.name, severity, maxWarnings: options.maxWarnings ?? configuration.maxWarnings },
  };
}

/** @throws Failure if a search is to end by the clock */
export function refuseTime({ budget }: Pick<PlanOptions, 'budget'>): void {
  if (budget === undefined) return;
  throw new Failure(
    `--budget ${budget}: by the clock, each machine would get other results: expected --effort TICKS, which is the same on all (default: ${DEFAULT_EFFORT})`,
  );
}

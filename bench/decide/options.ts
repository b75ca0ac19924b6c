import { DEFAULT_ACCURACY, isAccuracyName } from '../../engine/index.ts';
import { optionValue } from '../harness.ts';
import type { Effort } from './decide.ts';

/** What the command line asks for: `--accuracy`, `--budget`, `--refute`, `--refute-seconds`, `--jobs`. */
export interface Asked {
  readonly effort: Effort;
  /** Number of levels proved impossible that are searched afterwards. */
  readonly refute: number;
  /** Effort of searching those. */
  readonly refuteEffort: Effort;
  readonly jobs: number;
}

/**
 * Reads the options.
 * @param budget ticks a level unless `--budget` is given
 * @throws {RangeError} for an unknown accuracy
 */
export function askedEffort(budget: number): Asked {
  const accuracy = optionValue('--accuracy') ?? DEFAULT_ACCURACY;
  if (!isAccuracyName(accuracy))
    throw new RangeError(`--accuracy: expected arcade, fast, standard or precise, found ${accuracy}`);
  const effort: Effort = {
    accuracy,
    budget: Number(optionValue('--budget') ?? budget),
    refuteMs: 0,
  };
  return {
    effort,
    refute: Number(optionValue('--refute') ?? 0),
    refuteEffort: { ...effort, refuteMs: 1000 * Number(optionValue('--refute-seconds') ?? 60) },
    jobs: Number(optionValue('--jobs') ?? 1),
  };
}

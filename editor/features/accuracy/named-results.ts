import type { RunEnd } from '../../../check/words/index.ts';
import { ACCURACIES, type AccuracyName, compile, createSimulation, maxTicksOf, type Terms } from '../../../engine/index.ts';
import { deviationOf, pathOf, playerOf, type Reference } from '../../../engine/work-precision/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { type TurnsOptions, timeInTurns } from '../../core/figures/index.ts';
import { termsAt } from '../../core/terms/index.ts';

/** The result of a run at a named setting. */
export interface NamedResult {
  readonly name: AccuracyName;
  readonly end: RunEnd;
  /** The largest distance to `precise` at any tick before either ends, px. */
  readonly difference: number;
  /** Whether it ends as with `precise`. */
  readonly sameVerdict: boolean;
}

/** in display order */
export const NAMES = Object.keys(ACCURACIES) as readonly AccuracyName[];

/** Simulates a run at every named setting, with the other terms as they are, one per step; `precise` comes first, as the others are compared with it. */
export function* compareNamed(level: Level, terms: Terms, holds: readonly Hold[]): Generator<NamedResult, void, void> {
  const maxTicks = maxTicksOf(terms);
  let reference: Reference | null = null;
  for (const name of ['precise', ...NAMES.filter((other) => other !== 'precise')] as const) {
    const path = pathOf(createSimulation(compile(level, termsAt(terms, name))), holds, maxTicks);
    const ending = path.ending ?? { outcome: 'timeout' as const, with: null, time: terms.maxTime, tick: maxTicks };
    reference ??= { tolerance: ACCURACIES.precise.tolerance, path, outcome: ending.outcome, time: ending.time, floor: 0 };
    const { error, sameVerdict } = deviationOf(path, reference, maxTicks);
    yield { name, end: ending, difference: error, sameVerdict };
  }
}

/** Microseconds per simulated second, by the name of the setting. */
export type Costs = ReadonlyMap<AccuracyName, number>;

/** The cost of the named settings on a run, timed in turns; the minimum of the rounds counts. @returns null if aborted */
export async function costsOfNamed(
  level: Level,
  terms: Terms,
  holds: readonly Hold[],
  options: TurnsOptions,
): Promise<Costs | null> {
  const players = NAMES.map((name) => playerOf([{ level, holds }], ACCURACIES[name], maxTicksOf(terms)));
  const samples = await timeInTurns(players, options);
  return samples && new Map(NAMES.map((name, i) => [name, Math.min(...samples[i])]));
}

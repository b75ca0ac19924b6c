import type { RunEnd } from '../../../check/words/index.ts';
import { ACCURACIES, type AccuracyName, compile, createSimulation, DEFAULT_MAX_TIME, TICK_RATE } from '../../../engine/index.ts';
import { deviationOf, pathOf, playerOf, type Reference } from '../../../engine/work-precision/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { type TurnsOptions, timeInTurns } from '../figures/index.ts';

/** What a named setting makes of a run. */
export interface NamedResult {
  readonly name: AccuracyName;
  readonly end: RunEnd;
  /** Largest distance to `precise` at any tick before either ends, px. */
  readonly difference: number;
  /** It ends as under `precise`. */
  readonly sameVerdict: boolean;
}

const MAX_TICKS = DEFAULT_MAX_TIME * TICK_RATE;

/** In the order in which they are shown. */
export const NAMES = Object.keys(ACCURACIES) as readonly AccuracyName[];

/** Plays a run at every named setting, one a step: `precise` first, since it is what the others are compared with. */
export function* compareNamed(level: Level, holds: readonly Hold[]): Generator<NamedResult, void, void> {
  let reference: Reference | null = null;
  for (const name of ['precise', ...NAMES.filter((other) => other !== 'precise')] as const) {
    const path = pathOf(createSimulation(compile(level, name)), holds, MAX_TICKS);
    const ending = path.ending ?? { outcome: 'timeout' as const, with: null, time: DEFAULT_MAX_TIME, tick: MAX_TICKS };
    reference ??= { tolerance: ACCURACIES.precise.tolerance, path, outcome: ending.outcome, time: ending.time, floor: 0 };
    const { error, sameVerdict } = deviationOf(path, reference, MAX_TICKS);
    yield { name, end: ending, difference: error, sameVerdict };
  }
}

/** Microseconds per simulated second, by the name of the setting. */
export type Costs = ReadonlyMap<AccuracyName, number>;

/** What the named settings cost on a run, timed in turns: the least of the rounds. @returns null when it was aborted */
export async function costsOfNamed(level: Level, holds: readonly Hold[], options: TurnsOptions): Promise<Costs | null> {
  const players = NAMES.map((name) => playerOf([{ level, holds }], ACCURACIES[name], MAX_TICKS));
  const samples = await timeInTurns(players, options);
  return samples && new Map(NAMES.map((name, i) => [name, Math.min(...samples[i])]));
}

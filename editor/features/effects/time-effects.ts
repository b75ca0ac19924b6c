import { maxTicksOf, type Terms } from '../../../engine/index.ts';
import { playerOf } from '../../../engine/work-precision/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { type TurnsOptions, timeInTurns } from '../../core/figures/index.ts';

/** Measured times, microseconds per simulated second. */
export interface EffectTime {
  /** Of the run with all effects. */
  readonly all: number;
  /** What leaving the effect out saves. */
  readonly saved: number;
  /** The bounds of `saved` from the even and the odd rounds alone: how far it can be trusted. */
  readonly low: number;
  readonly high: number;
}

// Disturbances only make a measurement longer, so the minimum is closest to the truth.
const least = (samples: readonly number[]): number => Math.min(...samples);
const half = (samples: readonly number[], which: number): readonly number[] => samples.filter((_, i) => i % 2 === which);

/** What leaving an effect out saves, from the samples with and without it. */
export function savingOf(base: readonly number[], without: readonly number[]): EffectTime {
  const halves = [0, 1].map((which) => least(half(base, which)) - least(half(without, which)));
  const saved = least(base) - least(without);
  return { all: least(base), saved, low: Math.min(saved, ...halves), high: Math.max(saved, ...halves) };
}

/**
 * Times a run with all effects and without each effect, in turns.
 * @param without the level without each effect, by the effect's name
 * @returns the times by effect; null if aborted
 */
export async function timeEffects(
  level: Level,
  terms: Terms,
  holds: readonly Hold[],
  without: ReadonlyMap<string, Level>,
  options: TurnsOptions,
): Promise<ReadonlyMap<string, EffectTime> | null> {
  const players = [level, ...without.values()].map((played) =>
    playerOf([{ level: played, holds }], terms.accuracy, maxTicksOf(terms)),
  );
  const samples = await timeInTurns(players, options);
  if (samples === null) return null;
  return new Map([...without.keys()].map((name, i) => [name, savingOf(samples[0], samples[i + 1])]));
}

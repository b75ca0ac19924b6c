import { compile } from '../../../engine/index.ts';
import { EFFECT_TIMING, type EffectTime, timeByEffect } from '../../../engine/work-precision/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { job, type Played, type Work } from '../job.ts';

/** What the effects of a run take, microseconds per simulated second. */
export interface TimedEffects {
  /** The whole run. */
  readonly whole: number;
  readonly effects: readonly EffectTime[];
}

/** What each effect takes of a run's time; null under arcade. */
export const effects = job<Played & { readonly holds: readonly Hold[] }, TimedEffects | null>({
  name: 'effects',
  lane: 'long',
  most: 60_000,
});

export const effectsWork: Work<typeof effects> = {
  of: effects,
  // biome-ignore lint/correctness/useYield: turns that the page may interrupt would be timed with what interrupts them
  *steps({ level, terms, holds }, now) {
    const timed = timeByEffect(compile(level, terms), holds, now, EFFECT_TIMING);
    return timed && { whole: timed.whole.minimum, effects: timed.effects };
  },
};

import { compile, type Run, simulate, type Terms, type Work } from '../../../engine/index.ts';
import { type Hold, kindOfList, type Level, OBJECT_LISTS } from '../../../schema/index.ts';

/** Functions that leave one effect out of a level, by the effect's name. */
const LEAVE_OUT: Readonly<Record<string, (level: Level) => Level>> = {
  recoil: (level) => ({ ...level, recoil: false }),
  'alien-chase': (level) => ({ ...level, aliens: [] }),
  'hot-asteroids': (level) => ({ ...level, asteroids: level.asteroids.map((asteroid) => ({ ...asteroid, hot: false })) }),
};

/**
 * The level without one effect; null if no level can do without it. An effect named like a kind or its list is left out with
 * its objects.
 */
export function withoutEffect(level: Level, effect: string): Level | null {
  const leaveOut = LEAVE_OUT[effect];
  if (leaveOut !== undefined) return leaveOut(level);
  const list = OBJECT_LISTS.find((one) => one === effect || kindOfList(one) === effect);
  return list === undefined ? null : { ...level, [list]: [] };
}

/** What an effect costs in the shown run. */
export type EffectCost =
  /** no level can do without it */
  | { readonly kind: 'always' }
  /** Without it the path is the same: the saved work is its cost. */
  | { readonly kind: 'same'; readonly saved: Work; readonly level: Level }
  /** Without it the path differs, so the two runs can't be compared. */
  | { readonly kind: 'other'; readonly run: Run };

/** s: largest difference of two end times that count as equal */
const SAME_TIME = 1e-6;

/**
 * The cost of an effect: compares the run with the same holds in the level without it.
 * @param full the run with all effects
 */
export function costOf(level: Level, terms: Terms, holds: readonly Hold[], full: Run, effect: string): EffectCost {
  const without = withoutEffect(level, effect);
  if (without === null) return { kind: 'always' };
  const run = simulate(compile(without, terms), holds);
  const isSame =
    run.outcome === full.outcome &&
    run.with?.kind === full.with?.kind &&
    Math.abs(run.time - full.time) < SAME_TIME &&
    Math.hypot(run.final.x - full.final.x, run.final.y - full.final.y) < 1;
  if (!isSame) return { kind: 'other', run };
  const saved: Work = {
    pieces: full.work.pieces - run.work.pieces,
    forceEvaluations: full.work.forceEvaluations - run.work.forceEvaluations,
    guards: full.work.guards - run.work.guards,
    roots: full.work.roots - run.work.roots,
  };
  return { kind: 'same', saved, level: without };
}

import { type AccuracyName, compile, type Run, simulate, type Work } from '../../../engine/index.ts';
import { type Hold, kindOfList, type Level, OBJECT_LISTS } from '../../../schema/index.ts';

/** The level with one effect left out, by the effect's name. */
const LEAVE_OUT: Readonly<Record<string, (level: Level) => Level>> = {
  recoil: (level) => ({ ...level, recoil: false }),
  'alien-chase': (level) => ({ ...level, aliens: [] }),
  'hot-asteroids': (level) => ({ ...level, asteroids: level.asteroids.map((asteroid) => ({ ...asteroid, hot: false })) }),
};

/** The level with one effect left out; null for what no level can do without. An effect that is named like a kind, or its list, goes with the objects. */
export function withoutEffect(level: Level, effect: string): Level | null {
  const leaveOut = LEAVE_OUT[effect];
  if (leaveOut !== undefined) return leaveOut(level);
  const list = OBJECT_LISTS.find((one) => one === effect || kindOfList(one) === effect);
  return list === undefined ? null : { ...level, [list]: [] };
}

/** What an effect costs in the shown run. */
export type EffectCost =
  /** No level can do without it. */
  | { readonly kind: 'always' }
  /** Without it she flies the same way: what is saved is its cost. */
  | { readonly kind: 'same'; readonly saved: Work; readonly level: Level }
  /** Without it she flies another way, and the two can't be compared. */
  | { readonly kind: 'other'; readonly run: Run };

/** s: what two ways may differ by in when they end and still be the same */
const SAME_TIME = 1e-6;

/**
 * What an effect costs: the same run in the level without it.
 * @param full the run in the level as it is
 */
export function costOf(level: Level, accuracy: AccuracyName, holds: readonly Hold[], full: Run, effect: string): EffectCost {
  const without = withoutEffect(level, effect);
  if (without === null) return { kind: 'always' };
  const run = simulate(compile(without, accuracy), holds);
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

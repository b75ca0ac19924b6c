import type { LiveProof } from './answer.ts';

/** How far along time a run is shown. */
export interface Reach {
  /** The run it is about. */
  readonly run: string | null;
  /** The longest way since the run was shown or last completed the level, ticks. */
  readonly formerEnd: number;
  /** What is shown: up to the end, the former end and the last hold. */
  readonly ticks: number;
}

/**
 * How far a run is to be shown. Where it breaks, what came after stays in sight, so that it can be mended.
 * @param isInHand whether a gesture is going on: nothing shrinks under the hand
 */
export function reachOf({ run, limit }: Pick<LiveProof, 'run' | 'limit'>, before: Reach | null, isInHand: () => boolean): Reach {
  const end = Math.max(1, run.way.count - 1);
  const known = before !== null && before.run === run.name ? before : null;
  const completes = limit !== 'run' && run.outcome === 'completed';
  // who holds until she is through may have written any tick: the way itself is not to become a speck
  const seenUntil = (press: number, release: number) => (completes && press < end ? Math.min(release, 2 * end) : release);
  const lastHold = run.holds.reduce((last, [press, release]) => Math.max(last, seenUntil(press, release)), 0);
  const upTo = (formerEnd: number): Reach => ({ run: run.name, formerEnd, ticks: Math.max(end, formerEnd, lastHold) });
  if (known === null) return upTo(end);
  // what goes on without an end has none to be remembered
  const longest = run.outcome === 'timeout' ? known.formerEnd : Math.max(known.formerEnd, end);
  const now = upTo(completes ? end : longest);
  if (now.ticks >= known.ticks && now.formerEnd >= known.formerEnd) return now;
  return isInHand() ? { ...now, formerEnd: longest, ticks: Math.max(known.ticks, now.ticks) } : now;
}

import type { LiveProof } from './answer.ts';

/** How far along time a run is displayed. */
export interface Reach {
  /** The run that it belongs to. */
  readonly run: string | null;
  /** The longest run time since the run was shown or last completed the level, ticks. */
  readonly formerEnd: number;
  /** The displayed ticks: up to the end, the former end and the last hold. */
  readonly ticks: number;
}

/**
 * How far a run should be displayed. If it fails early, what came after stays visible, so that it can be fixed.
 * @param isInHand whether a gesture is in progress: the display must not shrink during one
 */
export function reachOf({ run, limit }: Pick<LiveProof, 'run' | 'limit'>, before: Reach | null, isInHand: () => boolean): Reach {
  const end = Math.max(1, run.way.count - 1);
  const known = before !== null && before.run === run.name ? before : null;
  const completes = limit !== 'run' && run.outcome === 'completed';
  // A last hold until she is through may have any release tick: it must not squeeze the run into a corner.
  const seenUntil = (press: number, release: number) => (completes && press < end ? Math.min(release, 2 * end) : release);
  const lastHold = run.holds.reduce((last, [press, release]) => Math.max(last, seenUntil(press, release)), 0);
  const upTo = (formerEnd: number): Reach => ({ run: run.name, formerEnd, ticks: Math.max(end, formerEnd, lastHold) });
  if (known === null) return upTo(end);
  // a run without an end has none to remember
  const longest = run.outcome === 'timeout' ? known.formerEnd : Math.max(known.formerEnd, end);
  const now = upTo(completes ? end : longest);
  if (now.ticks >= known.ticks && now.formerEnd >= known.formerEnd) return now;
  return isInHand() ? { ...now, formerEnd: longest, ticks: Math.max(known.ticks, now.ticks) } : now;
}

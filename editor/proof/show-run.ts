import type { RunEnd } from '../../check/words/index.ts';
import { joinHolds, type Run, TICK, TICK_RATE } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { ShownRun } from './answer.ts';
import { firstDifference, type Marched } from './march.ts';
import { type SceneRecord, toEnd } from './scene-record.ts';

/** Of several minerals touched in one frame `arcade` takes only one away, but counts them all: only the full record knows them. */
function takenInFrames(run: Run): Marched['minerals'] {
  const first = new Map<number, number>();
  for (const { index, time } of run.minerals) if (!first.has(index)) first.set(index, Math.round(time * TICK_RATE));
  return [...first].map(([index, tick]) => ({ index, tick }));
}

/**
 * Plays the run that is shown, tick by tick.
 * @param wanted its name; the first run where there is none of that name
 * @param shown holds of the run shown last; null: none was
 * @param isLate asked before each tick: whether to give up
 */
export function showRun(
  known: SceneRecord,
  level: Level,
  wanted: string | null,
  shown: readonly Hold[] | null,
  isLate: () => boolean,
): ShownRun & { readonly isCut: boolean } {
  const run = level.runs.find(({ name }) => name === wanted) ?? level.runs[0];
  const joined = joinHolds(run?.holds ?? []);
  // the same list as before, so that who shows it sees that it is
  const before = shown ?? joined;
  const holds = firstDifference(before, joined) === Number.POSITIVE_INFINITY ? before : joined;
  const { way, ending, minerals, resumedFrom, isCut } = known.march.run(holds, isLate);
  const inFrames = known.accuracy === 'arcade' && minerals.length > 0 && !isCut;
  const taken = inFrames ? takenInFrames(known.full(holds)) : minerals;
  const tick = Math.max(0, way.count - 1);
  const end: RunEnd = isCut ? { outcome: 'timeout', with: null, time: tick * TICK, tick } : toEnd(ending);
  return { name: run?.name ?? null, holds, way, minerals: taken, resumedFrom, isCut, ...end };
}

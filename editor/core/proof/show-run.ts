import { firstDifference } from '../../../check/runs/index.ts';
import type { RunEnd } from '../../../check/words/index.ts';
import { joinHolds, type Run, TICK, TICK_RATE } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import type { ShownRun } from './answer.ts';
import type { Marched } from './march.ts';
import { type SceneRecord, toEnd } from './scene-record.ts';

/**
 * If several minerals are touched in one frame, `arcade` removes only one but counts them all; only the full record knows them.
 */
function takenInFrames(run: Run): Marched['minerals'] {
  const first = new Map<number, number>();
  for (const { index, time } of run.minerals) if (!first.has(index)) first.set(index, Math.round(time * TICK_RATE));
  return [...first].map(([index, tick]) => ({ index, tick }));
}

/**
 * Simulates the shown run tick by tick.
 * @param wanted its name; the first run if there is none of that name
 * @param shown holds of the previously shown run; null: none
 * @param isLate called before each tick: whether to stop
 */
export function showRun(
  known: SceneRecord,
  level: Level,
  wanted: string | null,
  shown: readonly Hold[] | null,
  isLate: () => boolean,
): ShownRun & { readonly isCut: boolean; readonly looks: number } {
  const run = level.runs.find(({ name }) => name === wanted) ?? level.runs[0];
  const joined = joinHolds(run?.holds ?? []);
  // the same list as before if it is equal, so that subscribers see no change
  const before = shown ?? joined;
  const holds = firstDifference(before, joined) === Number.POSITIVE_INFINITY ? before : joined;
  const { way, ending, minerals, resumedFrom, isCut, looks } = known.march.run(holds, isLate);
  const inFrames = known.scene.accuracy.integrator === 'arcade' && minerals.length > 0 && !isCut;
  const taken = inFrames ? takenInFrames(known.full(holds).run) : minerals;
  const tick = Math.max(0, way.count - 1);
  const end: RunEnd = isCut ? { outcome: 'timeout', with: null, time: tick * TICK, tick } : toEnd(ending, known.maxTicks);
  return { name: run?.name ?? null, holds, way, minerals: taken, resumedFrom, isCut, looks, ...end };
}

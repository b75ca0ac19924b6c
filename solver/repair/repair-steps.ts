import type { Steps } from '../steps.ts';
import { adjustRun } from './adjust.ts';
import type { ObjectRef } from './change.ts';
import { relax } from './relax.ts';
import { moveHole, revive, touchedBy } from './revive.ts';
import { suspectsOf } from './suspects.ts';
import type { Task, Tried } from './task.ts';

/** So many of the level's own runs are tried: those that come nearest to the black hole. */
const MOST_RUNS = 3;

/** Ticks of the search of the level as it is. With a proof it only shows how near she can come. */
const SEARCH = 600_000;
const SEARCH_WHEN_PROVED = 100_000;

/**
 * The work of a repair, from what changes least to what changes most: nothing, the holds of the level's own runs, the level
 * around these runs, a new run, and the level with a new run.
 */
export function* repairSteps(task: Task): Steps<void> {
  const { level, proof, trials } = task;
  for (const [index, { holds }] of level.runs.entries()) {
    if (proof === null && trials.verify(level, holds) !== null) {
      task.completing = index;
      return;
    }
    yield null;
  }
  const own = level.runs
    .map(({ holds }, index) => ({ index, miss: trials.play(level, holds).miss }))
    .sort((a, b) => a.miss - b.miss)
    .slice(0, MOST_RUNS);
  if (proof === null) for (const { index } of own) yield* adjustRun(task, index);
  for (const { index } of own) yield* revive(task, { holds: level.runs[index].holds, origin: { from: 'own', index } });
  if (task.needsOnlyRun) return;

  const { found, closest } = yield* trials.search(level, task.nextSeed(), proof === null ? SEARCH : SEARCH_WHEN_PROVED);
  if (found !== null) {
    task.offer(null, { holds: found, origin: { from: 'search' } });
    if (task.needsOnlyRun) return;
  }
  const suspects: ObjectRef[] = proof === null ? [] : suspectsOf(level, proof);
  if (closest !== null) {
    const tried: Tried = { holds: closest, origin: { from: 'search' } };
    const attempt = trials.play(level, closest);
    yield* moveHole(task, tried, attempt);
    const touched = touchedBy(attempt);
    if (touched !== null && proof === null) suspects.push(touched);
  }
  yield* relax(task, suspects);
}

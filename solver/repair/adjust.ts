import { compile } from '../../engine/index.ts';
import { createRetime } from '../retime/index.ts';
import type { Steps } from '../steps.ts';
import type { Task } from './task.ts';

/** At most this many ticks are simulated for one run. */
const MOST_TICKS = 200_000;

/** Ticks between two breaks. */
const SLICE = 2000;

/**
 * Seeks small shifts of the presses and releases of one of the level's own runs with which it completes the level as it is, and
 * offers the smallest that it finds.
 */
export function* adjustRun(task: Task, index: number): Steps<void> {
  const { level, trials } = task;
  const { holds } = level.runs[index];
  if (holds.length === 0) return;
  const retime = createRetime(compile(level, trials.terms), holds, { centres: false });
  const before = { runs: trials.runs, ticks: trials.ticks };
  while (!retime.finished && retime.effort.ticks < MOST_TICKS) {
    retime.advance(SLICE);
    trials.runs = before.runs + retime.effort.runs;
    trials.ticks = before.ticks + retime.effort.ticks;
    yield null;
  }
  const { best } = retime;
  if (best !== null) task.offer(null, { holds: best.holds, origin: { from: 'adjusted', index, ticks: best.total } });
}

import { type Level, objectName } from '../../schema/basics/index.ts';
import type { Run } from '../simulate.ts';
import { STATE_SIZE } from '../simulation.ts';
import { px } from './bodies.ts';
import type { Rule } from './warning.ts';

// how often a run is sampled for the asteroids that keep her in range, s; she moves about 10 px in between
const LOOK_EVERY = 0.1;

// allowance for what happens between two samples, and for recoil, px
const MARGIN = 25;

/** An asteroid that no completing run uses. It may be scenery, a lure or left over; only the designer knows. */
export const unusedAsteroid: Rule = {
  explanation: {
    code: 'unused-asteroid',
    severity: 'warning',
    title: 'no run needs this asteroid',
    why: 'No run that completes the level targets this asteroid or needs it to keep her in range. If it is scenery or a lure, nothing is wrong. It may also be left over, or the level may be meant to be played in a way that none of its runs shows. Hot asteroids are never reported, because they are obstacles.',
    fix: 'Delete it, or add a run that uses it. If it is scenery or a lure, leave it.',
  },
  *find({ level, runs }) {
    const completed = runs.filter((run) => run.outcome === 'completed');
    if (completed.length === 0) return;
    const used = new Set<number>();
    for (const { events } of completed) for (const e of events) if (e.type === 'target') used.add(e.index);
    const idle = [...level.asteroids.keys()].filter((i) => !level.asteroids[i].hot && !used.has(i));
    if (idle.length === 0) return;
    const keepers = keepersOf(level, completed, used, idle);
    if (keepers === null) return;
    for (const i of idle) {
      if (keepers.has(i)) continue;
      yield {
        message:
          `${objectName('asteroid', i)} is not used: ${completed.length === 1 ? 'the run that completes the level does not target it' : `none of the ${completed.length} runs that complete the level targets it`}, ` +
          `and another asteroid is always within the range of ${px(level.range)}`,
        hint: 'delete it or add a run that uses it; if it is scenery or a lure, leave it',
        pointer: `/asteroids/${i}`,
      };
    }
  },
};

/** After this many distances, no asteroid of the level is said to be unused. */
const MOST_DISTANCES = 1e8;

/** Those of `idle` without which she would have been lost somewhere during a run; null if it takes too long to tell. */
function keepersOf(
  { asteroids, range }: Level,
  runs: readonly Run[],
  used: ReadonlySet<number>,
  idle: readonly number[],
): ReadonlySet<number> | null {
  const state = new Float64Array(STATE_SIZE);
  const keepers = new Set<number>();
  const others = [...asteroids.keys()].filter((i) => asteroids[i].hot || used.has(i));
  const near = (i: number, reach: number): boolean => {
    const dx = asteroids[i].x - state[0];
    const dy = asteroids[i].y - state[1];
    return dx * dx + dy * dy <= reach * reach;
  };
  let distances = 0;
  let left = idle;
  for (const { trajectory } of runs) {
    for (let time = 0; time < trajectory.duration && left.length > 0; time += LOOK_EVERY) {
      trajectory.at(time, state);
      const first = others.findIndex((i) => near(i, range - MARGIN));
      distances += first < 0 ? others.length : first + 1;
      if (first < 0) {
        // each of these would do; the designer chooses which to keep, so none is reported
        const found = left.filter((i) => near(i, range + MARGIN));
        for (const i of found) keepers.add(i);
        distances += left.length;
        if (found.length > 0) left = left.filter((i) => !keepers.has(i));
      }
      if (distances > MOST_DISTANCES) return null;
    }
  }
  return keepers;
}

import type { Hold } from '../../schema/basics/index.ts';
import type { Steps } from '../steps.ts';
import type { Task } from './task.ts';

/** Shifts that are tried, ticks, largest first. */
const SHIFTS = [32, 16, 8, 4, 2, 1];

/** No edge is shifted farther than this, ticks: it would be another run. */
const FARTHEST = 90;

/** At most this many trials for one run. */
const MOST_TRIALS = 400;

/**
 * Seeks small shifts of the presses and releases of one of the level's own runs with which it completes the level as it is, and
 * offers what it finds. One edge is shifted at a time, or all from one edge on, as long as that brings her nearer to the black
 * hole; then each edge goes back as far as the run still completes the level.
 */
export function* adjustRun(task: Task, index: number): Steps<void> {
  const own = task.level.runs[index].holds.flat();
  if (own.length === 0) return;
  const miss = (edges: readonly number[]): number => {
    const holds = holdsOf(edges);
    return holds === null ? Number.POSITIVE_INFINITY : task.trials.play(task.level, holds).miss;
  };
  let best: readonly number[] = own;
  let least = miss(own);
  let trials = 0;
  for (const shift of SHIFTS) {
    for (let improved = true; improved && least > 0 && trials < MOST_TRIALS; ) {
      improved = false;
      let next = best;
      for (const edges of shiftsOf(best, shift)) {
        if (edges.some((edge, i) => Math.abs(edge - own[i]) > FARTHEST)) continue;
        const found = miss(edges);
        trials++;
        yield null;
        if (found >= least) continue;
        least = found;
        next = edges;
        improved = true;
        if (least === 0) break;
      }
      best = next;
    }
  }
  if (least > 0) return;
  let edges = [...best];
  for (let more = true; more; ) {
    more = false;
    for (let i = 0; i < edges.length; i++) {
      for (const to of [own[i], Math.round((own[i] + edges[i]) / 2), edges[i] - Math.sign(edges[i] - own[i])]) {
        if (Math.abs(to - own[i]) >= Math.abs(edges[i] - own[i])) continue;
        const back = edges.with(i, to);
        yield null;
        if (miss(back) > 0) continue;
        edges = back;
        more = true;
        break;
      }
    }
  }
  const ticks = edges.reduce((sum, edge, i) => sum + Math.abs(edge - own[i]), 0);
  task.offer(null, { holds: holdsOf(edges) ?? [], origin: { from: 'adjusted', index, ticks } });
}

/** Each edge by itself, and all from each edge on, earlier and later. */
function* shiftsOf(edges: readonly number[], shift: number): Generator<number[]> {
  for (const by of [shift, -shift]) {
    for (let i = 0; i < edges.length; i++) {
      yield edges.map((edge, k) => (k === i ? edge + by : edge));
      if (i < edges.length - 1) yield edges.map((edge, k) => (k >= i ? edge + by : edge));
    }
  }
}

/** null when the edges are not in order. */
function holdsOf(edges: readonly number[]): Hold[] | null {
  const holds: Hold[] = [];
  for (let i = 0; i < edges.length; i += 2) holds.push([edges[i], edges[i + 1]]);
  return edges.every((edge, i) => edge > (i === 0 ? -1 : edges[i - 1])) ? holds : null;
}

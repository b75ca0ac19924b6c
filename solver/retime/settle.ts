import type { Steps } from '../steps.ts';
import { type Move, movesOf, shifted } from './moves.ts';
import type { Standing, Task } from './task.ts';

/** An edge that can slip by so many ticks either way is left where it is. */
const ENOUGH = 3;

/** So often all edges are centred, because each changes what the others forgive. */
const ROUNDS = 3;

/** Moves shifted edges back towards the given ones, as far as the run still completes the level with as many minerals. */
export function* shrink(task: Task): Steps<void> {
  const { own } = task;
  if (task.best === null) return;
  const moves = movesOf(task.count);
  task.compareWith(task.best.edges);
  yield null;
  for (let more = true; more; ) {
    more = false;
    for (const move of moves) {
      for (const edges of towards(task.best.edges, own, move)) {
        const before: Standing = task.best;
        task.attempt(edges);
        yield null;
        if (task.best === before) continue;
        more = true;
        break;
      }
    }
  }
}

/** The edges with those of a move back where they were, half way back, and one tick back. */
function* towards(edges: readonly number[], own: readonly number[], move: Move): Generator<number[]> {
  const away = edges[move[0]] - own[move[0]];
  if (away === 0) return;
  const steps = new Set([away, Math.trunc(away / 2), Math.sign(away)]);
  for (const by of steps) if (by !== 0) yield shifted(edges, move, -by);
}

/**
 * Moves edges that could hardly slip to where they can slip by {@link ENOUGH} ticks either way, or to the middle of what they can.
 * @returns the edges
 */
export function* centre(task: Task): Steps<readonly number[]> {
  const { best } = task;
  if (best === null) return [];
  let edges = best.edges;
  const meets = (tried: readonly number[]): boolean => {
    const probed = task.attempt(tried);
    return probed?.completed === true && probed.missing <= best.missing;
  };
  for (let round = 0; round < ROUNDS; round++) {
    let moved = false;
    for (let i = 0; i < task.count; i++) {
      task.compareWith(edges);
      yield null;
      const slack = { earlier: 0, later: 0 };
      for (const [side, sign] of SIDES) {
        while (slack[side] < 2 * ENOUGH && meets(shifted(edges, [i], sign * (slack[side] + 1)))) {
          slack[side]++;
          yield null;
        }
      }
      const by = centring(slack);
      if (by === 0) continue;
      edges = shifted(edges, [i], by);
      moved = true;
    }
    if (!moved) break;
  }
  return edges;
}

const SIDES = [
  ['earlier', -1],
  ['later', 1],
] as const;

/** By how much an edge with this slack is moved, ticks. */
function centring({ earlier, later }: { readonly earlier: number; readonly later: number }): number {
  const least = Math.min(earlier, later);
  const by = Math.min(ENOUGH - least, Math.floor(Math.abs(later - earlier) / 2));
  return by <= 0 ? 0 : later > earlier ? by : -by;
}

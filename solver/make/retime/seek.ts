import type { Steps } from '../../steps.ts';
import { type Move, movesOf, type NearMiss, shifted, type Task } from './task.ts';

/** Shifts that are tried around the given edges, ticks, the smallest first. */
const SIZES = [1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20, 24, 28, 32, 36, 40, 48, 56, 64, 72, 80, 90];

/** The others, up to the largest of them. */
const BETWEEN = Array.from({ length: SIZES[SIZES.length - 1] }, (_, i) => i + 1).filter((size) => !SIZES.includes(size));

/** Shifts around edges that worked a moment ago, ticks. */
const NEAR = [1, 2, 3, 4, 5, 6, 7, 8, 10, 12];

/** So many of the runs that came nearest are followed. */
const FOLLOWED = 6;

/** Steps by which a run is varied to come nearer, ticks. */
const STRIDES = [8, 4, 2, 1];

/** Sizes of two shifts that are tried together, ticks. */
const PAIRED = [4, 8, 16, 32];

/**
 * Seeks edges near the given ones with which the run completes the level: one shift, then shifts of what came nearest, then two
 * shifts at a time.
 * @param warm edges that worked a moment ago, if any
 */
export function* seek(task: Task, warm: readonly number[] | null): Steps<void> {
  const { own } = task;
  const moves = movesOf(task.count);
  const points: NearMiss[] = [];
  if (warm !== null) {
    const { miss } = task.compareWith(warm);
    yield null;
    if (task.best === null) {
      points.push({ edges: warm, miss });
      yield* scan(task, warm, moves, NEAR, points);
      if (task.best === null) yield* follow(task, moves, points);
    }
  }
  points.push({ edges: own, miss: task.compareWith(own).miss });
  yield null;
  yield* scan(task, own, moves, SIZES, points);
  if (!isDone(task)) yield* follow(task, moves, points);
  if (!isDone(task)) {
    yield* scanPairs(task, moves, points);
    if (!isDone(task)) yield* follow(task, moves, points);
  }
  task.compareWith(own);
  yield* scan(task, own, moves, BETWEEN, points);
}

const isDone = ({ best }: Task): boolean => best !== null && best.missing === 0;

/** Tries each move by each size, earlier and later. The task compares with `from`. */
function* scan(
  task: Task,
  from: readonly number[],
  moves: readonly Move[],
  sizes: readonly number[],
  points: NearMiss[],
): Steps<void> {
  for (const size of sizes) {
    for (const move of moves) {
      for (const by of [size, -size]) {
        const edges = shifted(from, move, by);
        if (task.isFutile(edges)) continue;
        const probed = task.attempt(edges);
        yield null;
        if (probed !== null && !probed.completed) points.push({ edges, miss: probed.miss });
      }
    }
  }
}

/** Tries two moves at a time. */
function* scanPairs(task: Task, moves: readonly Move[], points: NearMiss[]): Steps<void> {
  task.compareWith(task.own);
  for (const [k, first] of moves.entries()) {
    for (const second of moves.slice(k + 1)) {
      for (const a of PAIRED) {
        for (const b of PAIRED) {
          for (const [s, t] of SIGNS) {
            const edges = shifted(shifted(task.own, first, s * a), second, t * b);
            if (task.isFutile(edges)) continue;
            const probed = task.attempt(edges);
            yield null;
            if (probed !== null && !probed.completed) points.push({ edges, miss: probed.miss });
          }
        }
      }
    }
  }
}

const SIGNS = [
  [1, 1],
  [1, -1],
  [-1, 1],
  [-1, -1],
] as const;

/** Varies the runs that came nearest, as long as that brings them nearer. */
function* follow(task: Task, moves: readonly Move[], points: readonly NearMiss[]): Steps<void> {
  const nearest = [...points].sort((a, b) => a.miss - b.miss).slice(0, FOLLOWED);
  for (const start of nearest) {
    let now = start;
    for (const stride of STRIDES) {
      for (let improved = true; improved && now.miss > 0; ) {
        improved = false;
        task.compareWith(now.edges);
        yield null;
        let next = now;
        for (const move of moves) {
          for (const by of [stride, -stride]) {
            const edges = shifted(now.edges, move, by);
            const probed = task.attempt(edges);
            yield null;
            if (probed === null || probed.miss >= next.miss) continue;
            next = { edges, miss: probed.miss };
            improved = true;
          }
        }
        now = next;
      }
    }
  }
}

import type { Level } from '../../../schema/basics/index.ts';
import type { Steps } from '../../steps.ts';
import { applyChange, type Change, type ObjectRef, type Vector } from './change.ts';
import { dropOf, type Family, HOLE, moveFamily, movers, rangeFamily, resizeFamily, START, velocityFamily } from './family.ts';
import type { Task, Tried } from './task.ts';
import type { Attempt } from './trial-runs.ts';

/**
 * Seeks changes of the level with which a run completes it, the most likely ones first: of what the run hits, of the black
 * hole, and of whatever decides how she flies.
 */
export function* revive(task: Task, tried: Tried): Steps<void> {
  const { level } = task;
  const attempt = task.trials.play(level, tried.holds);
  const touched = touchedBy(attempt);
  if (touched !== null) yield* clear(task, touched, tried);
  yield* moveHole(task, tried, attempt);
  for (const family of familiesOfFlight(level)) yield* fitChange(task, family, tried);
}

/** Seeks changes of a hazard that let a run pass. */
export function* clear(task: Task, hazard: ObjectRef, tried: Tried): Steps<void> {
  const { level } = task;
  task.offer(dropOf(level, hazard), tried);
  yield null;
  yield* fitChange(task, resizeFamily(level, hazard), tried);
  yield* fitChange(task, moveFamily(level, hazard), tried);
}

/** Seeks changes of the black hole with which it lies on the way of a run. */
export function* moveHole(task: Task, tried: Tried, { nearest, miss }: Attempt): Steps<void> {
  const { level } = task;
  const length = lengthOf(nearest);
  const towards: Vector = length === 0 ? nearest : scaled(nearest, (Math.min(miss, length) + 1) / length);
  yield* fitChange(task, moveFamily(level, HOLE), tried, [towards]);
  yield* fitChange(task, resizeFamily(level, HOLE), tried, [{ x: miss + 1, y: 0 }]);
}

function familiesOfFlight(level: Level): Family[] {
  const objects = movers(level);
  return [
    rangeFamily(level),
    velocityFamily(level),
    moveFamily(level, START),
    ...objects.map((object) => moveFamily(level, object)),
    // The radius of an asteroid decides nothing but its recoil.
    ...objects.filter(({ kind }) => kind !== 'asteroid' || level.recoil).map((object) => resizeFamily(level, object)),
  ];
}

/** What ended a run before it was completed. */
export function touchedBy({ ending }: Attempt): ObjectRef | null {
  const touched = ending?.outcome === 'collided' ? ending.with : null;
  return touched === null || touched.kind === 'blackHole' ? null : { kind: touched.kind, index: touched.index };
}

/** Sizes that are tried first, px or px/s. */
const SIZES = [1, 2, 4, 8, 16, 32, 64, 128, 256];

/** Changes smaller than this are tried in half of the directions. */
const FEW_DIRECTIONS_BELOW = 8;

/** So many of the best of them are followed to where the run comes nearer. */
const FOLLOWED = 4;
/** The last step by which a change is varied, px or px/s. */
const LAST_STEP = 0.1;
/** At most this many trials follow one change. */
const MOST_TRIALS = 60;

/** Bisection ends when this is all that is left, px or px/s. */
const FINE = 0.05;

/** A direction is turned by these parts of a right angle, to find a smaller change. */
const TURNS = [0.5, 0.25, 0.1];

const H = Math.sqrt(0.5);
/** Cosine and sine of an eighth of a right angle times two: 22.5 degrees. */
const C = Math.sqrt((1 + H) / 2);
const S = Math.sqrt((1 - H) / 2);
const EIGHT: readonly Vector[] = [
  { x: 1, y: 0 },
  { x: H, y: H },
  { x: 0, y: 1 },
  { x: -H, y: H },
  { x: -1, y: 0 },
  { x: -H, y: -H },
  { x: 0, y: -1 },
  { x: H, y: -H },
];
const SIXTEEN: readonly Vector[] = EIGHT.flatMap((d) => [d, { x: d.x * C - d.y * S, y: d.x * S + d.y * C }]);
const SIGNS: readonly Vector[] = [
  { x: 1, y: 0 },
  { x: -1, y: 0 },
];

/** The directions of a family's changes that are tried. */
export const directionsOf = ({ isPlane }: Family, many = false): readonly Vector[] =>
  isPlane ? (many ? SIXTEEN : EIGHT) : SIGNS;

export const scaled = (v: Vector, by: number): Vector => ({ x: v.x * by, y: v.y * by });
export const lengthOf = ({ x, y }: Vector): number => Math.sqrt(x * x + y * y);

interface Trial {
  readonly by: Vector;
  readonly miss: number;
}

/**
 * Seeks a small change of one family with which a run completes the level, and offers what it finds.
 *
 * Sizes and directions are tried on a grid first. If none of them does, those that bring the run nearest to the black hole are
 * varied, ever more finely, to bring it nearer. What completes the level is then made smaller, see {@link shrink}.
 * @param guesses changes to try first, px or px/s
 */
function* fitChange(task: Task, family: Family, tried: Tried, guesses: readonly Vector[] = []): Steps<void> {
  const bound = () => task.boundOf(family.group);
  const miss = (by: Vector): number => {
    const change = family.make(by);
    return change === null ? Number.POSITIVE_INFINITY : task.trials.play(applyChange(task.level, change), tried.holds).miss;
  };
  let good: Vector | null = null;
  const points: Trial[] = [];
  const look = (by: Vector) => {
    const found = miss(by);
    if (found === 0) good = by;
    else points.push({ by, miss: found });
  };
  for (const by of guesses) {
    if (good !== null || lengthOf(by) >= bound()) continue;
    look(by);
    yield null;
  }
  for (const size of SIZES) {
    if (good !== null || size >= bound()) break;
    for (const direction of directionsOf(family, size >= FEW_DIRECTIONS_BELOW)) {
      if (good === null) look(scaled(direction, size));
      yield null;
    }
  }
  if (good === null) {
    points.sort((a, b) => a.miss - b.miss);
    for (const point of points.slice(0, FOLLOWED)) {
      const reached: Vector | null = yield* follow(point, family, miss, bound);
      if (reached === null) continue;
      yield* shrink(task, family, reached, tried);
    }
    return;
  }
  yield* shrink(task, family, good, tried);
}

/** Varies a change to bring the run nearer, with steps that halve when none does. */
function* follow(start: Trial, family: Family, miss: (by: Vector) => number, bound: () => number): Steps<Vector | null> {
  let best = start;
  let step = Math.max(LAST_STEP, lengthOf(start.by) / 2);
  for (let trials = 0; trials < MOST_TRIALS && step >= LAST_STEP; ) {
    let next: Trial = best;
    for (const direction of directionsOf(family)) {
      const by = { x: best.by.x + step * direction.x, y: best.by.y + step * direction.y };
      if (lengthOf(by) >= bound()) continue;
      const found = miss(by);
      trials++;
      yield null;
      if (found === 0) return by;
      if (found < next.miss) next = { by, miss: found };
    }
    if (next === best) step /= 2;
    best = next;
  }
  return null;
}

/**
 * Makes a change smaller as long as the run still completes the level: by bisection towards no change, and by turning its
 * direction. Nothing says that a smaller change fails wherever a larger one does, so what is found is the smallest that was
 * tried, not the smallest that there is.
 */
export function* shrink(task: Task, family: Family, start: Vector, tried: Tried): Steps<void> {
  const completes = (by: Vector): boolean => {
    const change = family.make(by);
    return change !== null && task.trials.play(applyChange(task.level, change), tried.holds).completed;
  };
  let best = yield* bisect(start, completes);
  if (family.isPlane) {
    for (const turn of TURNS) {
      for (let more = true; more; ) {
        more = false;
        for (const sign of [1, -1]) {
          const by = turned(best, sign * turn);
          yield null;
          if (!completes(by)) continue;
          const smaller: Vector = yield* bisect(by, completes);
          if (lengthOf(smaller) > 0.98 * lengthOf(best)) continue;
          best = smaller;
          more = true;
        }
      }
    }
  }
  const change: Change | null = family.make(best);
  if (change !== null) task.offer(change, tried);
}

function* bisect(start: Vector, completes: (by: Vector) => boolean): Steps<Vector> {
  let low = 0;
  let high = 1;
  const length = lengthOf(start);
  while ((high - low) * length > FINE) {
    const middle = (low + high) / 2;
    if (completes(scaled(start, middle))) high = middle;
    else low = middle;
    yield null;
  }
  return scaled(start, high);
}

/** The vector turned by about a part of a right angle, with its length. */
function turned(v: Vector, part: number): Vector {
  const cos = 1 / Math.sqrt(1 + part * part);
  const sin = part * cos;
  return { x: v.x * cos - v.y * sin, y: v.x * sin + v.y * cos };
}

import { isJump, type Run, STATE_SIZE, TICK, TICK_RATE } from '../engine/index.ts';

/** A stretch of a run with the gun held or not, as points in px of the level. */
export interface Stretch {
  readonly from: number;
  readonly to: number;
  readonly held: boolean;
  readonly points: readonly PathPoint[];
}

/** The simplified path may be off by this much, px of the level. */
const TOLERANCE = 0.2;

/** Where she was at a time in s. */
export function positionAt(run: Run, time: number): PathPoint {
  const state = new Float64Array(STATE_SIZE);
  run.trajectory.at(time, state);
  return [state[0], state[1]];
}

/** The times at which the gun was held, s, from the run's events. A hold that is not released lasts until the end. */
export function heldTimes(run: Run): [from: number, to: number][] {
  const held: [number, number][] = [];
  let pressed: number | null = null;
  for (const { type, time } of run.events) {
    if (type === 'press') pressed = time;
    if (type !== 'release' || pressed === null) continue;
    held.push([pressed, time]);
    pressed = null;
  }
  if (pressed !== null) held.push([pressed, run.trajectory.duration]);
  return held;
}

/**
 * Divides a run into consecutive stretches without gaps in time, sampled at 60 Hz and at each press and release, and cut where
 * an effect moves her at once.
 */
export function stretchesOf(run: Run): Stretch[] {
  const end = run.trajectory.duration;
  const stretches: Stretch[] = [];
  let at = 0;
  const add = (to: number, held: boolean): void => {
    const until = Math.min(to, end);
    if (until <= at) return;
    for (const flight of sample(run, at, until)) {
      stretches.push({ ...flight, held, points: simplify(flight.points, TOLERANCE) });
    }
    at = until;
  };
  for (const [press, release] of heldTimes(run)) {
    add(press, false);
    add(release, true);
  }
  add(end, false);
  return stretches;
}

type Flight = Pick<Stretch, 'from' | 'to'> & { readonly points: PathPoint[] };

function sample(run: Run, start: number, to: number): Flight[] {
  const flights: Flight[] = [];
  const states = new Float64Array(2 * STATE_SIZE);
  let from = start;
  let before = start;
  let points: PathPoint[] = [];
  const look = (time: number): void => {
    run.trajectory.at(time, states.subarray(STATE_SIZE));
    if (points.length > 0 && isJump(states, 0, STATE_SIZE, time - before)) {
      flights.push({ from, to: before, points });
      from = before;
      points = [];
    }
    points.push([states[STATE_SIZE], states[STATE_SIZE + 1]]);
    states.copyWithin(0, STATE_SIZE);
    before = time;
  };
  look(start);
  // The small offset keeps a boundary that is a tick from being sampled twice.
  for (let tick = Math.floor(start * TICK_RATE + 1e-6) + 1; tick * TICK < to - 1e-9; tick++) look(tick * TICK);
  look(to);
  flights.push({ from, to, points });
  return flights;
}

/** An alien that moved less than this is drawn at its place in the level, px of the level. */
const STIRRED = 8;

/** The path of an alien, px of the level, and whether it had exploded by the end; null when it hardly moved. */
export function alienWay(
  run: Run,
  alien: number,
  count: number,
): { readonly points: readonly PathPoint[]; readonly exploded: boolean } | null {
  const state = new Float64Array(3 * count);
  const points: PathPoint[] = [];
  const end = run.trajectory.duration;
  const look = (time: number): void => {
    run.trajectory.aliensAt(time, state);
    points.push([state[3 * alien], state[3 * alien + 1]]);
  };
  for (let tick = 0; tick * TICK < end; tick++) look(tick * TICK);
  look(end);
  const exploded = state[3 * alien + 2] === 0;
  const [x, y] = points[0];
  const moved = points.some(([px, py]) => Math.hypot(px - x, py - y) >= STIRRED);
  return moved || exploded ? { points: simplify(points, TOLERANCE), exploded } : null;
}

/** A point, px of the level or units of the picture. */
export type PathPoint = readonly [x: number, y: number];

/**
 * Removes points of a line that are less than `tolerance` away from the simplified line (Ramer 1972, Douglas and Peucker 1973).
 * The first and the last point stay. It is iterative, because recursion on a long run would overflow the stack.
 */
export function simplify(points: readonly PathPoint[], tolerance: number): PathPoint[] {
  if (points.length < 3) return [...points];
  const keep = new Uint8Array(points.length);
  keep[0] = 1;
  keep[points.length - 1] = 1;
  const spans: [number, number][] = [[0, points.length - 1]];
  for (let span = spans.pop(); span !== undefined; span = spans.pop()) {
    const [from, to] = span;
    let worst = tolerance * tolerance;
    let split = -1;
    for (let i = from + 1; i < to; i++) {
      const d = squaredDistance(points[i], points[from], points[to]);
      if (d <= worst) continue;
      worst = d;
      split = i;
    }
    if (split < 0) continue;
    keep[split] = 1;
    spans.push([from, split], [split, to]);
  }
  return points.filter((_, i) => keep[i] === 1);
}

/** Squared distance of a point from the segment a b. */
function squaredDistance([x, y]: PathPoint, [ax, ay]: PathPoint, [bx, by]: PathPoint): number {
  const dx = bx - ax;
  const dy = by - ay;
  const length = dx * dx + dy * dy;
  const t = length === 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / length));
  const ex = x - ax - t * dx;
  const ey = y - ay - t * dy;
  return ex * ex + ey * ey;
}

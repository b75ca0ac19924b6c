import { type Run, STATE_SIZE, TICK, TICK_RATE } from '../engine/index.ts';
import { type Point, simplify } from './simplify.ts';

/** A stretch of a run with the gun held or not, as points in level px. */
export interface Stretch {
  readonly from: number;
  readonly to: number;
  readonly held: boolean;
  readonly points: readonly Point[];
}

/** Strays less than this from where she was, level px. */
const TOLERANCE = 0.2;

/** Where she was at a time. */
export function positionAt(run: Run, time: number): Point {
  const state = new Float64Array(STATE_SIZE);
  run.trajectory.at(time, state);
  return [state[0], state[1]];
}

/** When the gun was held, s: from the run's own events. A hold that the run ended in lasts until the end. */
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

/** The run as stretches in turn, without a gap: sampled at 60 Hz and at each press and release. */
export function stretchesOf(run: Run): Stretch[] {
  const end = run.trajectory.duration;
  const stretches: Stretch[] = [];
  let at = 0;
  const add = (to: number, held: boolean): void => {
    const until = Math.min(to, end);
    if (until <= at) return;
    stretches.push({ from: at, to: until, held, points: simplify(sample(run, at, until), TOLERANCE) });
    at = until;
  };
  for (const [press, release] of heldTimes(run)) {
    add(press, false);
    add(release, true);
  }
  add(end, false);
  return stretches;
}

function sample(run: Run, from: number, to: number): Point[] {
  const points: Point[] = [positionAt(run, from)];
  // a hair, so that a boundary which is a tick is not sampled twice
  for (let tick = Math.floor(from * TICK_RATE + 1e-6) + 1; tick * TICK < to - 1e-9; tick++)
    points.push(positionAt(run, tick * TICK));
  points.push(positionAt(run, to));
  return points;
}

/** An alien that moved less than this is drawn where the level has it, level px. */
const STIRRED = 8;

/** The way of an alien, level px, and whether it had exploded by the end; null when it hardly moved. */
export function alienWay(
  run: Run,
  alien: number,
  count: number,
): { readonly points: readonly Point[]; readonly exploded: boolean } | null {
  const state = new Float64Array(3 * count);
  const points: Point[] = [];
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

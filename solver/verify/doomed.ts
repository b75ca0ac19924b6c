import { TICK } from '../../engine/index.ts';
import type { Disc, Place } from '../../schema/basics/index.ts';
import type { BoxNumbers, Doomed, FanGrid, ThingRef } from '../prove/index.ts';
import { farFromLimit } from './assumptions.ts';
import { type Claim, standingHazard } from './claim.ts';
import { isAxis, isCount, isFrom, type TurnedScene, turnedScene } from './turned-scene.ts';

/** All numbers between two. */
type Interval = readonly [number, number];

/** A set of states: intervals of place and velocity along both axes of the grid, px and px/s. */
export interface StateBox {
  readonly x: Interval;
  readonly y: Interval;
  readonly vx: Interval;
  readonly vy: Interval;
}

/** A set of places, px. */
export type Rectangle = Pick<StateBox, 'x' | 'y'>;

/** Far more than the rounding error of one step, px and px/s. */
const ROUNDING = 1e-7;

/** How late the engine may notice that she crosses a rim, px. */
const ON_RIM = 1e-6;

/**
 * `arcade` computes with the coordinates of the file: beyond this, px, the rounding errors of frames add up to more than {@link
 * ROUNDING}.
 */
const FAR_OUT = 1e6;

/** The most boxes of a certificate, and the most pieces of them to examine. */
const MOST_BOXES = 20_000;
const MOST_PIECES = 1_000_000;

/** The largest number in a box, px and px/s, so that nothing computed from it is infinite. */
const LARGEST = 1e9;

const add = (a: Interval, b: Interval): Interval => [a[0] + b[0] - ROUNDING, a[1] + b[1] + ROUNDING];
const hull = (a: Interval, b: Interval): Interval => [Math.min(a[0], b[0]), Math.max(a[1], b[1])];
const times = (a: Interval, b: Interval): Interval => {
  const products = [a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]];
  return [Math.min(...products), Math.max(...products)];
};

/**
 * Checks `doomed`: the sets of the certificate are reachable sets, which contain everything that she may do, whatever is
 * pressed.
 *
 * The check is an induction by interval arithmetic. The first set contains the start. One step of a set is contained in the
 * next set, except for the parts that have ended: they lie entirely in one hazard or out of range. No set comes near the object
 * within its step, and after the last step nothing is left. How the boxes were cut and joined does not matter. A step holds for
 * every method that pushes her as the game could push her at the places of that step, once per frame or continuously (lemma
 * `pushes` and `recoil in steps`). In frames a push acts on her velocity a frame later, so the places of the frame before belong
 * to a step as well, and the first step may have a frame's push less.
 */
export function checkDoomed(claim: Claim, { grid, layers }: Doomed): string | null {
  if (!isGrid(grid)) return 'its grid is not valid';
  if (!areLayers(layers)) return 'its sets are not valid';
  const { x, y, vx, vy } = claim.level.astronaut;
  if (claim.frames && Math.max(Math.abs(x), Math.abs(y)) > FAR_OUT) return 'with frames, rounding is too coarse so far out';
  const scene = turnedScene(claim, grid.axis);
  const seconds = grid.frames * TICK;
  // Each step begins no faster than the first one, or far from the limit on both axes, and stays below the limit.
  const fastest = Math.max(Math.sqrt(vx * vx + vy * vy), 1.4143 * farFromLimit(claim.rules));
  const push = claim.push + claim.blur;
  if (!(fastest + push * (seconds + TICK) <= claim.rules.speedLimit)) return 'she may reach the speed limit within a step';
  const blocked = blockedDiscs(claim, scene);
  let after: StateBox[] = [startOf(scene)];
  let looked = 0;
  for (let n = 0; n <= layers.length; n++) {
    const boxes = (layers[n] ?? []).map(boxOf);
    const inCells = new Map(boxes.map((box) => [cellOf(box, grid), box]));
    for (const piece of pieces(after, grid)) {
      if (++looked > MOST_PIECES) return 'following her takes too many boxes';
      const box = inCells.get(cellOf(piece, grid));
      if (box !== undefined && holds(box, piece)) continue;
      if (n === 0 || !isOver(scene, blocked, piece, n * seconds))
        return n < layers.length
          ? `its sets do not contain everything she may do by step ${n}`
          : `some runs may continue after ${n} steps`;
    }
    after = [];
    for (const box of boxes) {
      const way = placesWithin(box, seconds, push);
      if (!(distances(scene.thing, way)[0] > claim.touch + ROUNDING)) return `she may touch it in step ${n + 1}`;
      const mayJump = scene.mouths.some((mouth) => !(distances(mouth, way)[0] > mouth.radius + ON_RIM));
      if (mayJump) return `she may enter a wormhole in step ${n + 1}`;
      const lag = claim.frames ? TICK : 0;
      const pushed = accelerations(claim, scene, n === 0 ? way : withPlacesBefore(way, box, lag), (n + 1) * seconds);
      const moved = advance(box, ...pushed, seconds, n === 0 ? lag : 0);
      if (!(Math.max(-moved.vx[0], moved.vx[1], -moved.vy[0], moved.vy[1]) <= farFromLimit(claim.rules)))
        return 'she may reach the speed limit';
      after.push(moved);
    }
  }
  return null;
}

const isGrid = (grid: FanGrid | undefined): grid is FanGrid =>
  isAxis(grid?.axis) && isFrom(0.25, 1000, grid?.cell) && isFrom(0.25, 1000, grid?.bin) && isCount(1, 60, grid?.frames);

function areLayers(layers: Doomed['layers'] | undefined): layers is Doomed['layers'] {
  if (!Array.isArray(layers) || !layers.every(Array.isArray)) return false;
  const isBox = (box: BoxNumbers | undefined) =>
    Array.isArray(box) && box.length === 8 && box.every((n, i) => isFrom(i % 2 === 0 ? -LARGEST : box[i - 1], LARGEST, n));
  return layers.reduce((sum, { length }) => sum + length, 0) <= MOST_BOXES && layers.flat().every(isBox);
}

const boxOf = ([xa, xb, ya, yb, va, vb, wa, wb]: BoxNumbers): StateBox => ({
  x: [xa, xb],
  y: [ya, yb],
  vx: [va, vb],
  vy: [wa, wb],
});

const aboutZero: Interval = [-ROUNDING, ROUNDING];

const startOf = ({ velocity }: TurnedScene): StateBox => ({
  x: aboutZero,
  y: aboutZero,
  vx: [velocity.x - ROUNDING, velocity.x + ROUNDING],
  vy: [velocity.y - ROUNDING, velocity.y + ROUNDING],
});

/** The discs in which her centre cannot be, because her box contains a circle around its centre. */
function blockedDiscs(claim: Claim, { turn }: TurnedScene): Disc[] {
  const { novae, asteroids } = claim.level;
  const refs: ThingRef[] = [
    ...novae.map((_, index) => ({ kind: 'nova' as const, index })),
    ...asteroids.map((_, index) => ({ kind: 'asteroid' as const, index })),
    { kind: 'blackHole', index: 0 },
  ];
  return refs.flatMap((ref) => {
    const hazard = standingHazard(claim, ref);
    return hazard === null || hazard.radius <= 0 ? [] : [{ ...turn(hazard), radius: hazard.radius + claim.inner }];
  });
}

/** All places within the next `seconds`: the straight path, and how far any push can bend it. */
export function placesWithin({ x, y, vx, vy }: StateBox, seconds: number, push: number): Rectangle {
  const bend = 0.5 * push * seconds * (seconds + TICK);
  const along = (p: Interval, v: Interval) => add(add(p, times(v, [0, seconds])), [-bend, bend]);
  return { x: along(x, vx), y: along(y, vy) };
}

/** The same with the places where she was up to `lag` seconds before, drifting. */
export function withPlacesBefore(way: Rectangle, { x, y, vx, vy }: StateBox, lag: number): Rectangle {
  const before = (p: Interval, v: Interval) => add(p, times(v, [-lag, 0]));
  return { x: hull(way.x, before(x, vx)), y: hull(way.y, before(y, vy)) };
}

/**
 * Computes v t + a t² / 2 with an acceleration that may vary within its bounds. Frames push half a frame earlier or later.
 * @param missing for how long nothing has pushed her at first, s
 */
export function advance({ x, y, vx, vy }: StateBox, ax: Interval, ay: Interval, seconds: number, missing: number): StateBox {
  const weight: Interval = [0.5 * seconds * (seconds - TICK), 0.5 * seconds * (seconds + TICK)];
  const place = (p: Interval, v: Interval, a: Interval) => add(add(p, times(v, [seconds, seconds])), times(a, weight));
  const velocity = (v: Interval, a: Interval) => add(v, times(a, [seconds - missing, seconds]));
  return { x: place(x, vx, ax), y: place(y, vy, ay), vx: velocity(vx, ax), vy: velocity(vy, ay) };
}

/**
 * All possible accelerations at the places of a rectangle, with the gun on or off. Winds, and what fixed steps may add, come on
 * top of everything else.
 */
export function accelerations(
  { rules, blur }: Pick<Claim, 'rules' | 'blur'>,
  { asteroids, fields, winds, drift }: TurnedScene,
  way: Rectangle,
  seconds: number,
): [Interval, Interval] {
  const pushes = fields.flatMap((field) => {
    const [near, far] = distances(field, way);
    if (near > field.radius + ROUNDING) return [];
    const push = central(field, way, [near, far], (d) => -rules.push / d, rules.push, 0);
    return [{ push, always: far < field.radius - ROUNDING }];
  });
  const all = pushes.map(({ push }) => push);
  if (!pushes.some(({ always }) => always)) {
    all.push([
      [0, 0],
      [0, 0],
    ]);
    // The target is the nearest asteroid, so it is no farther than the one whose farthest place is nearest.
    const reach = asteroids.reduce(
      (least, a, i) => Math.min(least, distances(a, way)[1] + drift(i, seconds)),
      Number.POSITIVE_INFINITY,
    );
    for (const [i, asteroid] of asteroids.entries()) {
      const moved = drift(i, seconds);
      const near = distances(asteroid, way)[0] - moved;
      const far = distances(asteroid, way)[1] + moved;
      if (near > reach + ROUNDING) continue;
      const pull = (d: number) => Math.max(0, rules.pull / d - rules.pull / asteroid.radius);
      all.push(central(asteroid, way, [near, far], pull, rules.pull, moved));
    }
  }
  let [ax, ay] = [all.map(([x]) => x).reduce(hull), all.map(([, y]) => y).reduce(hull)];
  for (const wind of winds) {
    const [near, far] = distances(wind, way);
    if (near > wind.radius + ON_RIM) continue;
    const isIn = far < wind.radius - ON_RIM;
    const blowing = (a: number): Interval => (isIn ? [a, a] : [Math.min(0, a), Math.max(0, a)]);
    ax = add(ax, blowing(wind.ax));
    ay = add(ay, blowing(wind.ay));
  }
  const blurred: Interval = [-blur, blur];
  return [add(ax, blurred), add(ay, blurred)];
}

/**
 * A force towards a centre: `perPx(d)`, which is monotonic in d, times the vector to the centre. Very close to it, any
 * direction is possible.
 */
function central(
  centre: Place,
  { x, y }: Rectangle,
  [near, far]: Interval,
  perPx: (d: number) => number,
  strongest: number,
  moved: number,
): [Interval, Interval] {
  if (near < 1)
    return [
      [-strongest, strongest],
      [-strongest, strongest],
    ];
  const strength: Interval = [Math.min(perPx(near), perPx(far)), Math.max(perPx(near), perPx(far))];
  const way = (c: number, p: Interval): Interval => [c - p[1] - moved, c - p[0] + moved];
  const atMost = ([a, b]: Interval): Interval => [Math.max(-strongest, a), Math.min(strongest, b)];
  return [atMost(times(way(centre.x, x), strength)), atMost(times(way(centre.y, y), strength))];
}

/** Whether every place of a rectangle ends the run: it lies in one hazard, or out of range of all asteroids. */
function isOver({ asteroids, drift }: TurnedScene, blocked: readonly Disc[], places: Rectangle, seconds: number): boolean {
  if (blocked.some((disc) => distances(disc, places)[1] < disc.radius - ROUNDING)) return true;
  return asteroids.every((asteroid, i) => distances(asteroid, places)[0] > asteroid.radius + drift(i, seconds) + ROUNDING);
}

/** Distances from a place to the nearest and the farthest place of a rectangle. */
function distances(p: Place, { x, y }: Rectangle): Interval {
  const nearX = Math.max(0, x[0] - p.x, p.x - x[1]);
  const nearY = Math.max(0, y[0] - p.y, p.y - y[1]);
  const farX = Math.max(p.x - x[0], x[1] - p.x);
  const farY = Math.max(p.y - y[0], y[1] - p.y);
  return [Math.sqrt(nearX * nearX + nearY * nearY), Math.sqrt(farX * farX + farY * farY)];
}

/** Boxes, cut at the multiples of the grid's sizes. */
function* pieces(boxes: readonly StateBox[], { cell, bin }: FanGrid): Generator<StateBox> {
  for (const box of boxes) {
    for (const x of cut(box.x, cell)) {
      for (const y of cut(box.y, cell)) {
        for (const vx of cut(box.vx, bin)) for (const vy of cut(box.vy, bin)) yield { x, y, vx, vy };
      }
    }
  }
}

function* cut([from, to]: Interval, size: number): Generator<Interval> {
  const last = Math.floor(to / size);
  for (let n = Math.floor(from / size); n <= last; n++) yield [Math.max(from, n * size), Math.min(to, (n + 1) * size)];
}

/** The cell of the grid that contains the middle of a box. */
function cellOf({ x, y, vx, vy }: StateBox, { cell, bin }: FanGrid): string {
  const at = ([from, to]: Interval, size: number) => Math.floor((from + to) / 2 / size);
  return `${at(x, cell)} ${at(y, cell)} ${at(vx, bin)} ${at(vy, bin)}`;
}

const within = (a: Interval, b: Interval): boolean => a[0] <= b[0] && b[1] <= a[1];
const holds = (a: StateBox, b: StateBox): boolean =>
  within(a.x, b.x) && within(a.y, b.y) && within(a.vx, b.vx) && within(a.vy, b.vy);

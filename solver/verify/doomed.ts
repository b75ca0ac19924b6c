import { GUN_PULL, HALF_WIDTH, REPULSOR_PUSH, TICK } from '../../engine/index.ts';
import type { FanGrid } from '../proofs/index.ts';
import { driftIn, FAR_FROM_LIMIT } from './assumptions.ts';
import type { Claim } from './claim.ts';
import { standingHazard } from './hazards.ts';
import type { Point } from './rounded.ts';

/** All numbers from the first to the second. */
type Interval = readonly [number, number];

/** A set of states: places and velocities along both axes of the grid, px and px/s. */
export interface Box {
  readonly x: Interval;
  readonly y: Interval;
  readonly vx: Interval;
  readonly vy: Interval;
}

export type Rectangle = Pick<Box, 'x' | 'y'>;
type Circle = Point & { readonly radius: number };

/** Rounding of a step is far below this, px and px/s. */
const ROUNDING = 1e-7;

/** `arcade` reckons in places as they are in the file: beyond this, px, frames add up to more than {@link ROUNDING}. */
const FAR_OUT = 1e6;

/** A certificate may ask for no more boxes than this. */
const MOST_BOXES = 1_000_000;

const add = (a: Interval, b: Interval): Interval => [a[0] + b[0] - ROUNDING, a[1] + b[1] + ROUNDING];
const hull = (a: Interval, b: Interval): Interval => [Math.min(a[0], b[0]), Math.max(a[1], b[1])];
const times = (a: Interval, b: Interval): Interval => {
  const products = [a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]];
  return [Math.min(...products), Math.max(...products)];
};

/**
 * Follows all that she may do, whatever is pressed, in steps of some ticks: a set of boxes that holds every run which isn't
 * over. It holds for every way of playing that pushes her within a step as the game could push her at the places of that step, once a
 * frame or continuously. No box may come near the thing, and after the steps that the certificate names none may be left.
 */
export function checkDoomed(claim: Claim, grid: FanGrid): string | null {
  if (!isGrid(grid)) return 'its grid is none';
  const { x, y } = claim.level.astronaut;
  if (claim.frames && Math.max(Math.abs(x), Math.abs(y)) > FAR_OUT) return 'with frames places so far out are too coarse';
  const scene = turnedScene(claim, grid.axis);
  const seconds = grid.frames * TICK;
  let boxes: Box[] = [scene.start];
  let made = 0;
  for (let step = 1; step <= grid.steps; step++) {
    const next = new Map<string, Box>();
    for (const box of boxes) {
      const way = placesWithin(box, seconds, claim.push);
      if (distances(scene.thing, way)[0] <= claim.touch + ROUNDING) return `she may touch it in step ${step}`;
      const [ax, ay] = accelerations(scene, way, step * seconds);
      const after = advance(box, ax, ay, seconds);
      if (Math.max(-after.vx[0], after.vx[1], -after.vy[0], after.vy[1]) > FAR_FROM_LIMIT)
        return 'she may come to the speed limit';
      for (const x of cut(after.x, grid.cell)) {
        for (const y of cut(after.y, grid.cell)) {
          made++;
          if (isOver(scene, { x: x.piece, y: y.piece }, step * seconds)) continue;
          for (const vx of cut(after.vx, grid.bin)) {
            for (const vy of cut(after.vy, grid.bin)) {
              made++;
              const key = `${x.index} ${y.index} ${vx.index} ${vy.index}`;
              next.set(key, join({ x: x.piece, y: y.piece, vx: vx.piece, vy: vy.piece }, next.get(key)));
            }
          }
          if (made > MOST_BOXES) return 'it takes too many boxes to follow her';
        }
      }
    }
    boxes = [...next.values()];
    if (boxes.length === 0) return null;
  }
  return `some runs may go on after ${grid.steps} steps`;
}

function isGrid(grid: FanGrid | undefined): grid is FanGrid {
  if (!Array.isArray(grid?.axis) || grid.axis.length !== 2) return false;
  const [x, y] = grid.axis;
  const isCount = (n: unknown, most: number) => typeof n === 'number' && Number.isInteger(n) && n >= 1 && n <= most;
  const isSize = (n: unknown) => typeof n === 'number' && n >= 0.25 && n <= 1000;
  return (
    Math.abs(x * x + y * y - 1) < 1e-12 &&
    isSize(grid.cell) &&
    isSize(grid.bin) &&
    isCount(grid.frames, 60) &&
    isCount(grid.steps, 1000)
  );
}

export interface TurnedScene {
  readonly start: Box;
  readonly thing: Point;
  readonly hazards: readonly Circle[];
  /** radius: the range */
  readonly asteroids: readonly Circle[];
  readonly fields: readonly Circle[];
  /** how far recoil has carried an asteroid at most after so many seconds, px */
  drift(asteroid: number, seconds: number): number;
}

/** The level with the grid's first axis as x. */
export function turnedScene(claim: Claim, [ux, uy]: readonly [number, number]): TurnedScene {
  const { level, place } = claim;
  const turn = ({ x, y }: Point): Point => ({ x: x * ux + y * uy, y: y * ux - x * uy });
  const v = turn({ x: level.astronaut.vx, y: level.astronaut.vy });
  const about = (n: number): Interval => [n - ROUNDING, n + ROUNDING];
  const refs = [
    ...level.novae.map((_, index) => ({ kind: 'nova' as const, index })),
    ...level.asteroids.map((_, index) => ({ kind: 'asteroid' as const, index })),
    { kind: 'blackHole' as const, index: 0 },
  ];
  return {
    start: { x: about(0), y: about(0), vx: about(v.x), vy: about(v.y) },
    thing: turn(claim.thing),
    // her box holds a circle of 10 px about its centre
    hazards: refs.flatMap((ref) => {
      const hazard = standingHazard(claim, ref);
      return hazard === null || hazard.radius <= 0 ? [] : [{ ...turn(hazard), radius: hazard.radius + HALF_WIDTH }];
    }),
    asteroids: level.asteroids.map((a) => ({ ...turn(place(a)), radius: level.range })),
    fields: level.repulsors.map((field) => ({ ...turn(place(field)), radius: field.radius })),
    drift: (i, seconds) => driftIn(level, i, seconds * (seconds + TICK)),
  };
}

/** Every place of the next `seconds`: the straight way, and what any push can bend it by. */
export function placesWithin({ x, y, vx, vy }: Box, seconds: number, push: number): Rectangle {
  const bend = 0.5 * push * seconds * (seconds + TICK);
  const along = (p: Interval, v: Interval) => add(add(p, times(v, [0, seconds])), [-bend, bend]);
  return { x: along(x, vx), y: along(y, vy) };
}

/** v t + a t2 / 2, with an acceleration that may change within its bounds; frames push half a frame earlier or later. */
export function advance({ x, y, vx, vy }: Box, ax: Interval, ay: Interval, seconds: number): Box {
  const weight: Interval = [0.5 * seconds * (seconds - TICK), 0.5 * seconds * (seconds + TICK)];
  const place = (p: Interval, v: Interval, a: Interval) => add(add(p, times(v, [seconds, seconds])), times(a, weight));
  const velocity = (v: Interval, a: Interval) => add(v, times(a, [seconds, seconds]));
  return { x: place(x, vx, ax), y: place(y, vy, ay), vx: velocity(vx, ax), vy: velocity(vy, ay) };
}

/** Every acceleration at a place of the rectangle, with the gun on or off. */
export function accelerations({ asteroids, fields, drift }: TurnedScene, way: Rectangle, seconds: number): [Interval, Interval] {
  const pushes = fields.flatMap((field) => {
    const [near, far] = distances(field, way);
    if (near > field.radius + ROUNDING) return [];
    const push = central(field, way, [near, far], (d) => -REPULSOR_PUSH / d, REPULSOR_PUSH, 0);
    return [{ push, always: far < field.radius - ROUNDING }];
  });
  const all = pushes.map(({ push }) => push);
  if (!pushes.some(({ always }) => always)) {
    all.push([
      [0, 0],
      [0, 0],
    ]);
    // the target is nearest, so it is no farther than the one whose farthest place is nearest
    const reach = asteroids.reduce(
      (least, a, i) => Math.min(least, distances(a, way)[1] + drift(i, seconds)),
      Number.POSITIVE_INFINITY,
    );
    for (const [i, asteroid] of asteroids.entries()) {
      const moved = drift(i, seconds);
      const near = distances(asteroid, way)[0] - moved;
      const far = distances(asteroid, way)[1] + moved;
      if (near > reach + ROUNDING) continue;
      const pull = (d: number) => Math.max(0, GUN_PULL / d - GUN_PULL / asteroid.radius);
      all.push(central(asteroid, way, [near, far], pull, GUN_PULL, moved));
    }
  }
  return [all.map(([ax]) => ax).reduce(hull), all.map(([, ay]) => ay).reduce(hull)];
}

/** A force towards a centre: `perPx(d)`, which falls or grows with d throughout, times the way to it. Next to it, any direction. */
function central(
  centre: Point,
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
  return [times(way(centre.x, x), strength), times(way(centre.y, y), strength)];
}

/** Whether every place of a rectangle ends the run: it lies in one hazard, or out of range of all asteroids. */
function isOver({ hazards, asteroids, drift }: TurnedScene, places: Rectangle, seconds: number): boolean {
  if (hazards.some((hazard) => distances(hazard, places)[1] < hazard.radius - ROUNDING)) return true;
  return asteroids.every((asteroid, i) => distances(asteroid, places)[0] > asteroid.radius + drift(i, seconds) + ROUNDING);
}

/** Distances from a place to the nearest and the farthest place of a rectangle. */
function distances(p: Point, { x, y }: Rectangle): Interval {
  const nearX = Math.max(0, x[0] - p.x, p.x - x[1]);
  const nearY = Math.max(0, y[0] - p.y, p.y - y[1]);
  const farX = Math.max(p.x - x[0], x[1] - p.x);
  const farY = Math.max(p.y - y[0], y[1] - p.y);
  return [Math.sqrt(nearX * nearX + nearY * nearY), Math.sqrt(farX * farX + farY * farY)];
}

/** An interval cut at the multiples of `size`. */
function cut([from, to]: Interval, size: number): { index: number; piece: Interval }[] {
  const first = Math.floor(from / size);
  const count = Math.min(Math.floor(to / size) - first + 1, MOST_BOXES);
  return Array.from({ length: count }, (_, n) => {
    const index = first + n;
    return { index, piece: [Math.max(from, index * size), Math.min(to, (index + 1) * size)] };
  });
}

function join(a: Box, b: Box | undefined): Box {
  if (b === undefined) return a;
  return { x: hull(a.x, b.x), y: hull(a.y, b.y), vx: hull(a.vx, b.vx), vy: hull(a.vy, b.vy) };
}

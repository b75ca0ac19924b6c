import { GUN_PULL, HALF_DIAGONAL, HALF_HEIGHT, HALF_WIDTH, REPULSOR_PUSH, TICK } from '../../engine/index.ts';
import type { PipeGrid } from '../proofs/index.ts';
import { driftIn, FAR_FROM_LIMIT } from './assumptions.ts';
import { afterChase, type Chaser, eitherChaser } from './chasers.ts';
import type { Claim } from './claim.ts';
import { apart, type Point } from './rounded.ts';

/** Rounding of a step is far below this, px. */
const ROUNDING = 1e-7;

/** A certificate may ask for no more pieces of sets than this. */
const MOST = 25_000;

/** Eight directions around; that of n + 4 is opposite to n. */
const AROUND = 8;
const HALF_ROOT = Math.sqrt(0.5);
const COMPASS: readonly Point[] = [
  { x: 1, y: 0 },
  { x: HALF_ROOT, y: HALF_ROOT },
  { x: 0, y: 1 },
  { x: -HALF_ROOT, y: HALF_ROOT },
  { x: -1, y: 0 },
  { x: -HALF_ROOT, y: -HALF_ROOT },
  { x: 0, y: -1 },
  { x: HALF_ROOT, y: -HALF_ROOT },
];
const back = (n: number): number => (n + 4) % AROUND;

type Circle = Point & { readonly radius: number };

/** All places with `left <= x <= right` and `low <= y <= high`. */
interface Area {
  readonly left: number;
  readonly right: number;
  readonly low: number;
  readonly high: number;
}

/** The short side of her box points along `to`, the other way, or within a chord of `off` of either; all directions are within 2. */
interface Aim {
  readonly to: Point;
  readonly off: number;
}

/** An octagon: how far it goes at most in each direction of the compass, px. */
type Octagon = readonly number[];

/**
 * States with which she would be within an octagon at each of several times if she drifted, `atTimes[i]` that of time i; those that
 * nothing asks for any more are null.
 */
interface Bundle {
  readonly atTimes: readonly (Octagon | null)[];
  readonly aim: Aim;
  readonly chasers: readonly Chaser[];
}

/**
 * Follows all that she may do in continuous time, in steps of some ticks. States are known by the octagons in which a drift from now on would be at the times
 * between the steps: a push a(s) moves the drift to time t by the integral of (t - s) a(s). After each step that part of an octagon is cut off in which her
 * box surely overlaps a hazard. No drift and push of a step may come near the thing, and after the steps of the certificate no state may be left.
 */
export function checkFlowpipe(claim: Claim, grid: PipeGrid): string | null {
  if (claim.frames) return 'with frames she is pushed and looked at once a frame only';
  if (!isGrid(grid)) return 'its grid is none';
  const seconds = grid.frames * TICK;
  const { vx, vy } = claim.level.astronaut;
  if (Math.sqrt(vx * vx + vy * vy) + claim.push * seconds * grid.steps > FAR_FROM_LIMIT) return 'she may come to the speed limit';
  const scene = sceneOf(claim, grid);
  let bundles: readonly Bundle[] = [scene.start];
  let made = 0;
  for (let step = 1; step <= grid.steps; step++) {
    const next = new Map<string, Bundle>();
    for (const bundle of bundles) {
      const way = wayTo(bundle, step, seconds, claim.push);
      if (distances(scene.thing, way).least <= claim.touch + ROUNDING) return `she may touch it in step ${step}`;
      for (const after of afterStep(scene, bundle, way, step)) {
        for (const [key, piece] of pieces(scene, after, step)) {
          if (++made > MOST) return 'it takes too many pieces to follow her';
          const left = survivors(scene, piece, step);
          if (left === null) continue;
          const there = next.get(key);
          next.set(key, there === undefined ? left : either(there, left));
        }
      }
    }
    bundles = [...next.values()];
    if (bundles.length === 0) return null;
  }
  return `some runs may go on after ${grid.steps} steps`;
}

function isGrid(grid: PipeGrid | undefined): grid is PipeGrid {
  if (!Array.isArray(grid?.axis) || grid.axis.length !== 2) return false;
  const [x, y] = grid.axis;
  const isCount = (n: unknown, least: number, most: number) =>
    typeof n === 'number' && Number.isInteger(n) && n >= least && n <= most;
  return (
    Math.abs(x * x + y * y - 1) < 1e-12 &&
    typeof grid.cell === 'number' &&
    grid.cell >= 0.25 &&
    grid.cell <= 1000 &&
    isCount(grid.frames, 1, 60) &&
    isCount(grid.steps, 3, 400) &&
    isCount(grid.turns, 1, 64)
  );
}

interface Scene {
  readonly claim: Claim;
  readonly grid: PipeGrid;
  readonly start: Bundle;
  readonly thing: Point;
  readonly rocks: readonly Circle[];
  readonly fields: readonly Circle[];
  /** circles that end the run, at a time */
  hazards(seconds: number): readonly Circle[];
  /** how far recoil has carried an asteroid at most */
  drift(asteroid: number, seconds: number): number;
  /** The two times over whose octagons the grid lies. */
  readonly times: readonly [number, number];
}

/** The level with the grid's first axis as x. */
function sceneOf(claim: Claim, grid: PipeGrid): Scene {
  const { level, place, about } = claim;
  const [ux, uy] = grid.axis;
  const turn = ({ x, y }: Point): Point => ({ x: x * ux + y * uy, y: y * ux - x * uy });
  const circle = (c: Circle): Circle => ({ ...turn(place(c)), radius: c.radius });
  const v = turn({ x: level.astronaut.vx, y: level.astronaut.vy });
  const drift = (i: number, seconds: number) => driftIn(level, i, seconds * (seconds + TICK));
  const rocks = level.asteroids.map(circle);
  const standing = level.novae.map(circle);
  if (about.kind === 'mineral') standing.push(circle(level.blackHole));
  const octagon = (p: Point): Octagon => COMPASS.map((d) => dot(d, p) + ROUNDING);
  const seconds = grid.frames * TICK;
  return {
    claim,
    grid,
    rocks,
    drift,
    thing: turn(claim.thing),
    fields: level.repulsors.map(circle),
    hazards: (time) => [
      ...standing,
      ...rocks.flatMap((rock, i) => (level.asteroids[i].hot ? [{ ...rock, radius: rock.radius - drift(i, time) }] : [])),
    ],
    times: [Math.floor(grid.steps / 3), grid.steps],
    start: {
      atTimes: Array.from({ length: grid.steps + 1 }, (_, i) => octagon({ x: v.x * i * seconds, y: v.y * i * seconds })),
      aim: { to: turn({ x: 1, y: 0 }), off: ROUNDING },
      chasers: level.aliens.map((alien) => ({
        at: { centre: turn(place(alien)), within: 0 },
        speed: { centre: { x: 0, y: 0 }, within: 0 },
        radius: alien.radius,
        isThere: true,
      })),
    },
  };
}

/** Where she may be in a step: the drift between its two ends, and how far a push can take her from that. */
function wayTo({ atTimes }: Bundle, step: number, seconds: number, push: number): Area {
  const before = atTimes[step - 1] as Octagon;
  const after = atTimes[step] as Octagon;
  // and a hundredth of a px for the stages of a method that steps
  const bend = (push * seconds * seconds) / 2 + 0.01;
  const most = (n: number) => Math.max(before[n], after[n]) + bend;
  return { left: -most(4), right: most(0), low: -most(6), high: most(2) };
}

/** What may become of a bundle: pressed at some time of the step, or not at all. */
function afterStep(scene: Scene, bundle: Bundle, way: Area, step: number): Bundle[] {
  const seconds = scene.grid.frames * TICK;
  const { pull, aim } = gun(scene, way, step * seconds);
  const field = fieldsAt(scene, way);
  const chasers = afterChase(bundle.chasers, way, seconds);
  const zero = COMPASS.map(() => 0);
  const free = field === null ? null : field.always ? field.push : most(field.push, zero);
  const pressed = field?.always === true ? field.push : most(most(pull, zero), free ?? zero);
  const pushed = (forces: readonly number[]) =>
    bundle.atTimes.map((octagon, i) => {
      if (octagon === null || (i < step && !scene.times.includes(i))) return null;
      // the integral of the time left to time i; where that has passed, the push counts the other way
      const lever = seconds * seconds * (i - step + 0.5);
      return octagon.map((far, n) => far + (lever > 0 ? lever * forces[n] : -lever * forces[back(n)]) + ROUNDING);
    });
  return [
    { atTimes: pushed(pressed), aim, chasers },
    { atTimes: free === null ? bundle.atTimes : pushed(free), aim: bundle.aim, chasers },
  ];
}

const most = (a: readonly number[], b: readonly number[]): number[] => a.map((far, n) => Math.max(far, b[n]));

/** How far the gun can accelerate her in each direction, wherever she is on the way, and where her box points while it is held. */
function gun({ claim, rocks, drift }: Scene, way: Area, seconds: number): { pull: readonly number[]; aim: Aim } {
  const { range, recoil } = claim.level;
  const middle = middleOf(way);
  const nearest = rocks.reduce((best, rock) => (apart(rock, middle) < apart(best, middle) ? rock : best), rocks[0]);
  const reach = rocks.reduce(
    (least, rock, i) => Math.min(least, distances(rock, way).most + drift(i, seconds)),
    Number.POSITIVE_INFINITY,
  );
  const corners = cornersOf(way);
  let pull: readonly number[] = COMPASS.map(() => Number.NEGATIVE_INFINITY);
  let aim: Aim | null = null;
  for (const [i, rock] of rocks.entries()) {
    const moved = drift(i, seconds);
    const { least, most: farthest } = distances(rock, way);
    if (least - moved > reach + ROUNDING) continue;
    // without recoil the border between two targets is a straight line
    const isBeaten = !recoil && corners.every((p) => apart(p, nearest) + 10 * ROUNDING < apart(p, rock));
    if (rock !== nearest && isBeaten) continue;
    const way0 = { x: rock.x - middle.x, y: rock.y - middle.y };
    const d = apart(rock, middle);
    const blur = halfDiagonal(way) + moved + ROUNDING;
    if (d - blur < 4) return { pull: COMPASS.map(() => GUN_PULL), aim: { to: { x: 1, y: 0 }, off: 2 } };
    const perPx = (at: number) => Math.max(0, GUN_PULL / at - GUN_PULL / range);
    // how much the pull changes with a px of her place: tangentially by what is left of GUN_PULL / d, radially by GUN_PULL / range
    const slope = Math.max(GUN_PULL / (d - blur), GUN_PULL / range);
    pull = most(
      pull,
      COMPASS.map((direction) => {
        const ahead = Math.max(...corners.map((p) => dot(direction, { x: rock.x - p.x, y: rock.y - p.y }))) + moved;
        const byPlace = ahead * perPx(ahead > 0 ? least - moved : farthest + moved);
        return Math.min(byPlace, perPx(d) * dot(direction, way0) + slope * blur) + ROUNDING;
      }),
    );
    // the chord of an angle whose sine is at most a half is at most 1.04 times that sine
    const here: Aim =
      blur > d / 2 ? { to: { x: 1, y: 0 }, off: 2 } : { to: { x: way0.x / d, y: way0.y / d }, off: (1.1 * blur) / d };
    aim = aim === null ? here : eitherAim(aim, here);
  }
  return { pull, aim: aim ?? { to: { x: 1, y: 0 }, off: 2 } };
}

/** How far fields can push her in each direction; null out of all of them. */
function fieldsAt({ fields }: Scene, way: Area): { push: readonly number[]; always: boolean } | null {
  const middle = middleOf(way);
  const blur = halfDiagonal(way) + ROUNDING;
  const near = fields.filter((field) => distances(field, way).least <= field.radius + ROUNDING);
  if (near.length === 0) return null;
  const pushes = near.map((field) => {
    const d = apart(field, middle);
    return COMPASS.map((direction) => {
      if (d - blur < 2) return REPULSOR_PUSH;
      const there = (REPULSOR_PUSH * dot(direction, { x: middle.x - field.x, y: middle.y - field.y })) / d;
      return Math.min(REPULSOR_PUSH, there + (REPULSOR_PUSH * blur) / (d - blur)) + ROUNDING;
    });
  });
  return { push: pushes.reduce(most), always: near.some((field) => distances(field, way).most < field.radius - ROUNDING) };
}

/** A range of cells, and whether it is cut into them at all. */
interface Cut {
  readonly cells: readonly number[];
  readonly isCut: boolean;
}

/** A bundle cut along the grid over the octagons of two times, where it is wide; what has one key may be joined. */
function pieces({ grid, times }: Scene, bundle: Bundle, step: number): [key: string, piece: Bundle][] {
  const { cell } = grid;
  const cut = (from: number, to: number): Cut => {
    if (to - from <= 1.6 * cell) return { cells: [Math.floor((from + to) / (2 * cell))], isCut: false };
    const first = Math.floor(from / cell);
    return { cells: Array.from({ length: Math.floor(to / cell) - first + 1 }, (_, n) => first + n), isCut: true };
  };
  const octagons = times.map((time) => bundle.atTimes[time] as Octagon);
  const cuts = octagons.flatMap((octagon) => [cut(-octagon[4], octagon[0]), cut(-octagon[6], octagon[2])]);
  const points = turnClass(bundle.aim.to, grid.turns);
  const all = cuts.reduce<number[][]>((ways, { cells }) => ways.flatMap((way) => cells.map((c) => [...way, c])), [[]]);
  return all.flatMap((cells): [string, Bundle][] => {
    const key = `${cells.join(' ')} ${points}`;
    if (cuts.every(({ isCut }) => !isCut)) return [[key, bundle]];
    const limit = octagons.map((octagon, n) => {
      const [across, down] = [2 * n, 2 * n + 1];
      const upTo = (own: number, axis: number, line: number) => (cuts[axis].isCut ? Math.min(own, line) : own);
      const right = upTo(octagon[0], across, (cells[across] + 1) * cell);
      const left = upTo(octagon[4], across, -cells[across] * cell);
      const high = upTo(octagon[2], down, (cells[down] + 1) * cell);
      const low = upTo(octagon[6], down, -cells[down] * cell);
      return COMPASS.map(({ x, y }) => (x > 0 ? x * right : -x * left) + (y > 0 ? y * high : -y * low));
    });
    const atTimes = bundle.atTimes.map((octagon, i) => {
      if (octagon === null || (i < step && !times.includes(i))) return null;
      // a drift is a straight line: its place at one time follows from those at two
      const share = (times[1] - i) / (times[1] - times[0]);
      const part = (weight: number, of: readonly number[], n: number) => (weight >= 0 ? weight * of[n] : -weight * of[back(n)]);
      return octagon.map((far, n) => Math.min(far, part(share, limit[0], n) + part(1 - share, limit[1], n) + ROUNDING));
    });
    const isEmpty = atTimes.some((octagon) => octagon?.some((far, n) => far + octagon[back(n)] < -ROUNDING));
    return isEmpty ? [] : [[key, { ...bundle, atTimes }]];
  });
}

/** What of a bundle is not over at the end of a step, or null. */
function survivors(scene: Scene, bundle: Bundle, step: number): Bundle | null {
  const seconds = step * scene.grid.frames * TICK;
  let octagon = bundle.atTimes[step] as Octagon;
  const deadly = [
    ...scene.hazards(seconds),
    ...bundle.chasers.flatMap(({ at, radius, isThere }) => (isThere ? [{ ...at.centre, radius: radius - at.within }] : [])),
  ];
  for (const hazard of deadly) {
    const left = outOf(octagon, hazard, bundle.aim);
    if (left === null) return null;
    octagon = left;
  }
  const here: Area = { left: -octagon[4], right: octagon[0], low: -octagon[6], high: octagon[2] };
  const { range } = scene.claim.level;
  const isLost = scene.rocks.every((rock, i) => distances(rock, here).least > range + scene.drift(i, seconds) + ROUNDING);
  return isLost ? null : { ...bundle, atTimes: bundle.atTimes.map((old, i) => (i === step ? octagon : old)) };
}

/**
 * An octagon without what is so near to a circle that her box must overlap it: by the circle in her box, and by the box as it is turned. Both times these places
 * are convex, so that they hold a rectangle of which they hold the corners.
 */
function outOf(octagon: Octagon, { x, y, radius }: Circle, { to, off }: Aim): Octagon | null {
  const reach = radius + HALF_DIAGONAL;
  if (x > octagon[0] + reach || -x > octagon[4] + reach || y > octagon[2] + reach || -y > octagon[6] + reach) return octagon;
  const inCircle = (p: Point) => apart(p, { x, y }) < radius + HALF_WIDTH - ROUNDING;
  const inBox = (p: Point) => {
    const way = { x: x - p.x, y: y - p.y };
    const beyond = {
      x: Math.max(0, Math.abs(dot(way, to)) - HALF_WIDTH),
      y: Math.max(0, Math.abs(way.y * to.x - way.x * to.y) - HALF_HEIGHT),
    };
    return apart(beyond, { x: 0, y: 0 }) + HALF_DIAGONAL * off < radius - ROUNDING;
  };
  let left = octagon;
  for (const isIn of [inCircle, inBox]) {
    for (const first of [0, 1]) {
      const result = withoutSide(left, first, isIn);
      if (result === null) return null;
      left = result;
    }
  }
  return left;
}

/** The octagon without a strip along one side of the rectangle around it, turned by eighths; null when nothing is left. */
function withoutSide(octagon: Octagon, first: number, isIn: (p: Point) => boolean): Octagon | null {
  const sides = [0, 2, 4, 6].map((n) => (first + n) % AROUND);
  // the corner between a side and the next, at given distances along them
  const corner = (n: number, far: number, farNext: number): Point => {
    const a = COMPASS[sides[n]];
    const b = COMPASS[sides[(n + 1) % 4]];
    return { x: a.x * far + b.x * farNext, y: a.y * far + b.y * farNext };
  };
  const corners = sides.map((side, n) => isIn(corner(n, octagon[side], octagon[sides[(n + 1) % 4]])));
  if (corners.every(Boolean)) return null;
  for (const [n, side] of sides.entries()) {
    const before = (n + 3) % 4;
    if (!corners[n] || !corners[before]) continue;
    const next = octagon[sides[(n + 1) % 4]];
    const previous = octagon[sides[before]];
    const strip = (far: number) => isIn(corner(n, far, next)) && isIn(corner(before, previous, far));
    let inside = octagon[side];
    let outside = -octagon[back(side)];
    for (let i = 0; i < 8; i++) {
      const half = (inside + outside) / 2;
      if (strip(half)) inside = half;
      else outside = half;
    }
    return octagon.map((far, m) => (m === side ? Math.min(far, inside + ROUNDING) : far));
  }
  return octagon;
}

/** A bundle that holds two others. */
function either(a: Bundle, b: Bundle): Bundle {
  return {
    atTimes: a.atTimes.map((octagon, i) => {
      const other = b.atTimes[i];
      return octagon === null || other === null ? null : most(octagon, other);
    }),
    aim: eitherAim(a.aim, b.aim),
    chasers: a.chasers.map((chaser, i) => eitherChaser(chaser, b.chasers[i])),
  };
}

/** Half a turn of her box changes nothing. */
function eitherAim(a: Aim, b: Aim): Aim {
  const sign = dot(a.to, b.to) < 0 ? -1 : 1;
  const other = { x: sign * b.to.x, y: sign * b.to.y };
  const sum = { x: a.to.x + other.x, y: a.to.y + other.y };
  const size = apart(sum, { x: 0, y: 0 });
  const to = { x: sum.x / size, y: sum.y / size };
  return { to, off: Math.min(2, Math.max(apart(to, a.to) + a.off, apart(to, other) + b.off) + 1e-12) };
}

/** In which part of half a turn a direction lies: by where it meets the square about the origin with its corners on the axes. */
function turnClass(d: Point, parts: number): number {
  const p = d.y < 0 || (d.y === 0 && d.x < 0) ? { x: -d.x, y: -d.y } : d;
  const along = (1 - p.x / (Math.abs(p.x) + p.y)) / 2;
  return Math.min(parts - 1, Math.floor(along * parts));
}

const dot = (a: Point, b: Point): number => a.x * b.x + a.y * b.y;
const middleOf = ({ left, right, low, high }: Area): Point => ({ x: (left + right) / 2, y: (low + high) / 2 });
const halfDiagonal = ({ left, right, low, high }: Area): number => apart({ x: left, y: low }, { x: right, y: high }) / 2;
const cornersOf = ({ left, right, low, high }: Area): Point[] => [left, right].flatMap((x) => [low, high].map((y) => ({ x, y })));

/** Distances from a place to the nearest and to the farthest place of an area. */
function distances(p: Point, area: Area): { least: number; most: number } {
  const beside = { x: Math.max(0, area.left - p.x, p.x - area.right), y: Math.max(0, area.low - p.y, p.y - area.high) };
  return { least: apart(beside, { x: 0, y: 0 }), most: Math.max(...cornersOf(area).map((corner) => apart(corner, p))) };
}

import {
  add,
  isShort,
  length,
  minus,
  multiply,
  NOWHERE,
  negate,
  subtract,
  times,
  toNumber,
  type Vector,
  ZERO,
} from '../double-double.ts';
import { type Along, actingIn, chases, rimOf, type Surroundings, timeToCentre } from '../forces.ts';
import { spend } from '../stretch.ts';
import type { Mover, World } from '../world.ts';
import { advance, type Central, central, distanceAlong, follow, isMoving, lineOf, type Path, standing } from './path.ts';
import { DEGREE, Series } from './series.ts';
import { Sliding } from './sliding.ts';

/** How far a series may be from the truth at its end, px, px/s or 1. */
export const TAYLOR_TOLERANCE = 1e-27;

/** The longest stretch, s. */
const LONGEST = 2;

/** Units of time are not shorter, s: what needs one takes too many stretches anyway. */
const SHORTEST_UNIT = 1e-60;

/** The motion of all until something happens: series of `s`, of which one is `unit` seconds. */
export interface Flow {
  /** A power of 2, s. */
  readonly unit: number;
  /** Up to which `s` the series hold. */
  readonly reach: number;
  readonly her: Path;
  /** The direction of her box. */
  readonly cos: Series;
  readonly sin: Series;
  readonly asteroids: readonly Path[];
  readonly aliens: readonly Path[];
  /** Her acceleration as if there were no speed limit, px/s². */
  readonly forceX: Series;
  readonly forceY: Series;
  /** While she slides on a rim: which share of the force inside acts, the rest being of the force outside. */
  readonly insideShare: Series | null;
  /** How far the centres are along the lines on which she or her target moves, px: a line passes its centre where it is 0. */
  readonly centres: readonly Series[];
  /** Her distance from the nearest centre of a force that is not on her line, px. */
  readonly besideCentre: number;
}

/** Expands the motion from now on. */
export function expand(world: World): Flow {
  const { rules, her, slide } = world;
  const acting = actingIn(world);
  const { target, outside, inside, lines, slope, recoil, turns } = acting;
  // so that coefficients are neither huge nor tiny
  const centre = timeToCentre(world, acting);
  let unit = 1;
  while (unit > centre && unit > SHORTEST_UNIT) unit /= 2;

  const beside = (body: Mover | null, line: Along): number =>
    body === null || line !== null ? Number.POSITIVE_INFINITY : toNumber(length(minus(body.at, her.at)));

  const hers = lineOf(her, unit);
  const pathOf = (body: Mover, isDriven: boolean) => (isDriven || isMoving(body) ? lineOf(body, unit) : standing(body.at));
  const asteroids = world.asteroids.map((body) => pathOf(body, body === target));
  const aliens = world.aliens.map((body) => pathOf(body, chases(body)));
  const gun = target === null ? null : central(lines.gun);
  const centralOf = ({ field }: Surroundings): Central | null => (field === null ? null : central(lines.field));
  const push = centralOf(outside);
  const pushInside = inside.field?.at === outside.field?.at ? push : centralOf(inside);
  const chased = world.aliens.map((alien) => (chases(alien) ? central(null) : null));
  const sliding = slide === null ? null : new Sliding(rimOf(world), hers);
  const forceX = new Series();
  const forceY = new Series();

  /** Coefficient `k` of the force in some surroundings. */
  const forceIn = ({ wind }: Surroundings, field: Central | null, k: number): Vector => {
    const steady = k === 0 ? wind : NOWHERE;
    if (field !== null) {
      return {
        x: subtract(steady.x, times(field.ux.get(k), rules.push)),
        y: subtract(steady.y, times(field.uy.get(k), rules.push)),
      };
    }
    if (gun === null) return steady;
    // pull (1 - d / range) along the unit vector
    return {
      x: add(steady.x, subtract(times(gun.ux.get(k), rules.pull), multiply(slope, gun.dx.get(k)))),
      y: add(steady.y, subtract(times(gun.uy.get(k), rules.pull), multiply(slope, gun.dy.get(k)))),
    };
  };
  const isFree = gun === null && push === null && sliding === null && chased.every((chase) => chase === null);
  // a steady force alone has one coefficient
  for (let k = 0; k <= (isFree ? 0 : DEGREE); k++) {
    if (gun !== null) follow(gun, hers, asteroids[world.target], k);
    if (push !== null) follow(push, hers, standing(outside.field!.at), k);
    if (pushInside !== null && pushInside !== push) {
      follow(pushInside, hers, standing(inside.field!.at), k);
    }
    let force = forceIn(outside, push, k);
    if (sliding !== null) force = sliding.force(forceIn(inside, pushInside, k), force, k);
    forceX.set(k, force.x);
    forceY.set(k, force.y);
    if (k < DEGREE) {
      advance(hers, world.limits[0] === 0 ? force.x : ZERO, world.limits[1] === 0 ? force.y : ZERO, k, unit);
      if (gun !== null && recoil.hi > 0) {
        advance(
          asteroids[world.target],
          negate(multiply(gun.ux.get(k), recoil)),
          negate(multiply(gun.uy.get(k), recoil)),
          k,
          unit,
        );
      }
    }
    for (const [i, chase] of chased.entries()) {
      if (chase === null) continue;
      spend(world, 1);
      follow(chase, aliens[i], hers, k);
      if (k === DEGREE) continue;
      advance(aliens[i], times(chase.ux.get(k), rules.alienPull), times(chase.uy.get(k), rules.alienPull), k, unit);
    }
  }
  const centrals = [gun, push, pushInside, ...chased].filter((c) => c !== null);
  const moving = [hers, ...asteroids, ...aliens].filter((path) => !path.stands);
  const series = [
    ...moving.flatMap((p) => [p.x, p.y, p.vx, p.vy]),
    ...centrals.flatMap((c) => [c.ux, c.uy]),
    ...(sliding === null ? [] : [sliding.share]),
  ];
  return {
    unit,
    reach: Math.min(LONGEST / unit, ...series.map(reachOf)),
    her: hers,
    cos: turns && gun !== null ? gun.ux : Series.line(world.box.x),
    sin: turns && gun !== null ? gun.uy : Series.line(world.box.y),
    asteroids,
    aliens,
    forceX,
    forceY,
    insideShare: sliding?.share ?? null,
    besideCentre: Math.min(beside(target, lines.gun), beside(outside.field, lines.field)),
    centres: [gun, push].filter((c) => c !== null && c.along !== null && !isShort(c.along, 0.5)).map((c) => distanceAlong(c!)),
  };
}

/** Up to which value of its variable a series holds, from its last two coefficients. */
function reachOf(series: Series): number {
  const size = Math.max(1, 1e-5 * Math.abs(series.hi[0]));
  let reach = Number.POSITIVE_INFINITY;
  for (const k of [DEGREE, DEGREE - 1]) {
    const c = Math.abs(series.hi[k]);
    if (c > 0) reach = Math.min(reach, rootBelow((TAYLOR_TOLERANCE * size) / c, k));
  }
  return reach;
}

/** A number whose power is at most `value`, and nearly that: powers of other numbers than 2 differ between engines. */
function rootBelow(value: number, k: number): number {
  let low = 1;
  while (power(low, k) > value) low /= 2;
  while (power(2 * low, k) <= value) low *= 2;
  let high = 2 * low;
  for (let n = 0; n < 8; n++) {
    const middle = (low + high) / 2;
    if (power(middle, k) > value) high = middle;
    else low = middle;
  }
  return low;
}

function power(base: number, k: number): number {
  let made = 1;
  for (let i = 0; i < k; i++) made *= base;
  return made;
}

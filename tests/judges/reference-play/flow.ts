import type { Level } from '../../../schema/index.ts';
import {
  add,
  dd,
  divide,
  isShort,
  length,
  minus,
  multiply,
  NOWHERE,
  plus,
  subtract,
  times,
  toNumber,
  type Vector,
  vector,
  ZERO,
} from './double-double.ts';
import { type Along, type Lines, linesOf } from './lines.ts';
import { advance, type Central, central, distanceAlong, follow, isMoving, lineOf, type Path, standing } from './path.ts';
import { DEGREE, Series } from './series.ts';
import { Sliding } from './sliding.ts';
import { type Mover, placeOf, type World } from './world.ts';

/** How far a series may be from the truth at its end, px, px/s or 1. */
const TOLERANCE = 1e-27;

/** The longest stretch, s. */
const LONGEST = 2;

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

/** The first field that contains her; -1 if none does. */
const actingField = (fields: readonly boolean[]): number => fields.indexOf(true);

/** What acts on her besides the gun. */
interface Surroundings {
  /** The field that pushes her, instead of the gun's pull. */
  readonly field: number;
  readonly wind: Vector;
}

/** Expands the motion from now on. */
export function expand(world: World): Flow {
  const { level, rules, her, slide } = world;
  const outside = surroundings(world, false);
  const inside = slide === null ? outside : surroundings(world, true);
  const target = world.held && world.target >= 0 ? world.asteroids[world.target] : null;
  const fieldOf = ({ field }: Surroundings): Mover | null =>
    field < 0 ? null : { at: placeOf(level.repulsors[field]), velocity: NOWHERE };
  const repulsor = fieldOf(outside);
  const recoil = level.recoil && target !== null ? rules.recoil / (2 * level.asteroids[world.target].radius) : 0;
  const lines = slide === null ? linesOf(world, target, repulsor, outside.wind, recoil) : NO_LINES;
  const unit = timeUnit(world, target, slide === null ? repulsor : (fieldOf(inside) ?? repulsor), lines);

  const beside = (body: Mover | null, line: Along): number =>
    body === null || line !== null ? Number.POSITIVE_INFINITY : toNumber(length(minus(body.at, her.at)));

  const hers = lineOf(her, unit);
  const pathOf = (body: Mover, isDriven: boolean) => (isDriven || isMoving(body) ? lineOf(body, unit) : standing(body.at));
  const asteroids = world.asteroids.map((body) => pathOf(body, body === target));
  const aliens = world.aliens.map((body) => pathOf(body, body.awake && !body.gone));
  const gun = target === null ? null : central(lines.gun);
  const centralOf = ({ field }: Surroundings): Central | null => (field < 0 ? null : central(lines.field));
  const push = centralOf(outside);
  const pushInside = inside.field === outside.field ? push : centralOf(inside);
  const chases = world.aliens.map((alien) => (alien.awake && !alien.gone ? central(null) : null));
  const sliding = slide === null ? null : new Sliding(rimOf(world), hers);
  const forceX = new Series();
  const forceY = new Series();
  const pull = dd(rules.pull);
  const slope = divide(pull, dd(level.range));
  const drawn = target === null ? ZERO : divide(dd(rules.recoil), dd(-2 * level.asteroids[world.target].radius));
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
      x: add(steady.x, subtract(multiply(pull, gun.ux.get(k)), multiply(slope, gun.dx.get(k)))),
      y: add(steady.y, subtract(multiply(pull, gun.uy.get(k)), multiply(slope, gun.dy.get(k)))),
    };
  };
  const isFree = gun === null && push === null && sliding === null && chases.every((chase) => chase === null);
  // a steady force alone has one coefficient
  for (let k = 0; k <= (isFree ? 0 : DEGREE); k++) {
    if (gun !== null) follow(gun, hers, asteroids[world.target], k);
    if (push !== null) follow(push, hers, standing(placeOf(level.repulsors[outside.field])), k);
    if (pushInside !== null && pushInside !== push) {
      follow(pushInside, hers, standing(placeOf(level.repulsors[inside.field])), k);
    }
    let force = forceIn(outside, push, k);
    if (sliding !== null) force = sliding.force(forceIn(inside, pushInside, k), force, k);
    forceX.set(k, force.x);
    forceY.set(k, force.y);
    if (k < DEGREE) {
      advance(hers, world.limits[0] === 0 ? force.x : ZERO, world.limits[1] === 0 ? force.y : ZERO, k, unit);
      if (gun !== null && recoil > 0) {
        advance(asteroids[world.target], multiply(gun.ux.get(k), drawn), multiply(gun.uy.get(k), drawn), k, unit);
      }
    }
    for (const [i, chase] of chases.entries()) {
      if (chase === null) continue;
      follow(chase, aliens[i], hers, k);
      if (k === DEGREE) continue;
      advance(aliens[i], times(chase.ux.get(k), rules.alienPull), times(chase.uy.get(k), rules.alienPull), k, unit);
    }
  }
  const turns = gun !== null && !lines.restsInTarget;
  const centrals = [gun, push, pushInside, ...chases].filter((c) => c !== null);
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
    cos: turns ? gun.ux : Series.line(world.box.x),
    sin: turns ? gun.uy : Series.line(world.box.y),
    asteroids,
    aliens,
    forceX,
    forceY,
    insideShare: sliding?.share ?? null,
    besideCentre: Math.min(beside(target, lines.gun), beside(repulsor, lines.field)),
    centres: [gun, push].filter((c) => c !== null && c.along !== null && !isShort(c.along, 0.5)).map((c) => distanceAlong(c!)),
  };
}

const NO_LINES: Lines = { gun: null, field: null, restsInTarget: false };

/** What acts on her. @param isInside - whether the rim on which she slides counts as containing her, where she does */
function surroundings(world: World, isInside: boolean): Surroundings {
  const { level, slide } = world;
  const flags = (kind: 'field' | 'wind', list: readonly boolean[]) =>
    slide?.kind === kind ? list.map((flag, i) => (i === slide.index ? isInside : flag)) : list;
  const winds = flags('wind', world.winds);
  const wind = level.winds.reduce((sum, { ax, ay }, i) => (winds[i] ? plus(sum, vector(ax, ay)) : sum), NOWHERE);
  return { field: actingField(flags('field', world.fields)), wind };
}

/** The circle on whose rim she slides. */
function rimOf({ level, slide }: World): Level['winds'][number] | Level['repulsors'][number] {
  return slide!.kind === 'field' ? level.repulsors[slide!.index] : level.winds[slide!.index];
}

/** About the time in which the nearest centre is reached, as a power of 2: so that coefficients are neither huge nor tiny. */
function timeUnit(world: World, target: Mover | null, repulsor: Mover | null, lines: Lines): number {
  let least = 1;
  const consider = (a: Mover, b: Mover, acceleration: number) => {
    const u = minus(a.at, b.at);
    const v = minus(a.velocity, b.velocity);
    const d = Math.hypot(u.x.hi, u.y.hi);
    least = Math.min(least, d / (Math.hypot(v.x.hi, v.y.hi) + Math.sqrt(acceleration * d)));
  };
  const strength = world.rules.pull + world.rules.push + 200;
  if (target !== null && lines.gun === null) consider(target, world.her, strength);
  if (repulsor !== null && lines.field === null) consider(repulsor, world.her, strength);
  for (const alien of world.aliens) if (alien.awake && !alien.gone) consider(alien, world.her, strength + world.rules.alienPull);
  return 2 ** Math.max(-200, Math.floor(Math.log2(least)));
}

/** Up to which value of its variable a series holds, from its last two coefficients. */
function reachOf(series: Series): number {
  const size = Math.max(1, 1e-5 * Math.abs(series.hi[0]));
  let reach = Number.POSITIVE_INFINITY;
  for (const k of [DEGREE, DEGREE - 1]) {
    const c = Math.abs(series.hi[k]);
    if (c > 0) reach = Math.min(reach, ((TOLERANCE * size) / c) ** (1 / k));
  }
  return reach;
}

import {
  add,
  cross,
  type Dd,
  dd,
  direction,
  divide,
  dot,
  isShort,
  length,
  minus,
  multiply,
  NOWHERE,
  ONE,
  plus,
  scaled,
  squareRoot,
  subtract,
  times,
  toNumber,
  type Vector,
  vector,
  ZERO,
} from './double-double.ts';
import { DEGREE, productAt, Series } from './series.ts';
import { type Mover, NO_LENGTH, placeOf, type World } from './world.ts';

/** The reference does not know how to go on: the caller leaves the scene out, and counts it. */
export class NotCovered extends Error {}

/** How far a series may be from the truth at its end, px, px/s or 1. */
const TOLERANCE = 1e-27;

/** The longest stretch, s. */
const LONGEST = 2;

/** Places and velocities as series of the stretch's variable. */
export interface Path {
  readonly x: Series;
  readonly y: Series;
  readonly vx: Series;
  readonly vy: Series;
  /** Whether it stays where it is. */
  readonly stands: boolean;
}

/** A line through the centre of a force: the direction to it stays the same. */
type Along = Vector | null;

/** One body that is drawn towards a centre, or pushed away. `ux`, `uy` is the unit vector towards the centre. */
interface Central {
  readonly dx: Series;
  readonly dy: Series;
  readonly d2: Series;
  readonly weighted: Series;
  readonly inverse: Series;
  readonly ux: Series;
  readonly uy: Series;
  readonly along: Along;
}

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
  /** How far the centres are along the lines on which she or her target moves, px: a line passes its centre where it is 0. */
  readonly centres: readonly Series[];
  /** Her distance from the nearest centre of a force that is not on her line, px. */
  readonly besideCentre: number;
}

/** The fields' first that contains her; -1 if none does. */
export const actingField = ({ fields }: World): number => fields.indexOf(true);

/** Expands the motion from now on. */
export function expand(world: World): Flow {
  const { level, rules, her } = world;
  const field = actingField(world);
  const target = world.held && world.target >= 0 ? world.asteroids[world.target] : null;
  const repulsor: Mover | null = field < 0 ? null : { at: placeOf(level.repulsors[field]), velocity: NOWHERE };
  const recoil = level.recoil && target !== null ? rules.recoil / (2 * level.asteroids[world.target].radius) : 0;
  const wind = blowing(world);
  const lines = linesOf(world, target, repulsor, wind, recoil);
  const unit = timeUnit(world, target, repulsor, lines);

  const beside = (body: Mover | null, line: Along): number =>
    body === null || line !== null ? Number.POSITIVE_INFINITY : toNumber(length(minus(body.at, her.at)));

  const hers = lineOf(her, unit);
  const pathOf = (body: Mover, isDriven: boolean) => (isDriven || isMoving(body) ? lineOf(body, unit) : standing(body.at));
  const asteroids = world.asteroids.map((body) => pathOf(body, body === target));
  const aliens = world.aliens.map((body) => pathOf(body, body.awake && !body.gone));
  const gun = target === null ? null : central(lines.gun);
  const push = repulsor === null ? null : central(lines.field);
  const centre = repulsor === null ? hers : standing(repulsor.at);
  const chases = world.aliens.map((alien) => (alien.awake && !alien.gone ? central(null) : null));
  const forceX = new Series();
  const forceY = new Series();
  const pull = dd(rules.pull);
  const slope = divide(pull, dd(level.range));
  const drawn = target === null ? ZERO : divide(dd(rules.recoil), dd(-2 * level.asteroids[world.target].radius));
  const isFree = gun === null && push === null && chases.every((chase) => chase === null);
  // a steady force alone has one coefficient
  for (let k = 0; k <= (isFree ? 0 : DEGREE); k++) {
    if (gun !== null) follow(gun, hers, asteroids[world.target], k);
    if (push !== null) follow(push, hers, centre, k);
    let fx = k === 0 ? wind.x : ZERO;
    let fy = k === 0 ? wind.y : ZERO;
    if (push !== null) {
      fx = subtract(fx, times(push.ux.get(k), rules.push));
      fy = subtract(fy, times(push.uy.get(k), rules.push));
    } else if (gun !== null) {
      // pull (1 - d / range) along the unit vector
      fx = add(fx, subtract(multiply(pull, gun.ux.get(k)), multiply(slope, gun.dx.get(k))));
      fy = add(fy, subtract(multiply(pull, gun.uy.get(k)), multiply(slope, gun.dy.get(k))));
    }
    forceX.set(k, fx);
    forceY.set(k, fy);
    if (k < DEGREE) {
      advance(hers, world.limits[0] === 0 ? fx : ZERO, world.limits[1] === 0 ? fy : ZERO, k, unit);
      if (gun !== null && recoil > 0) {
        advance(asteroids[world.target], multiply(gun.ux.get(k), drawn), multiply(gun.uy.get(k), drawn), k, unit);
      }
    }
    for (let i = 0; i < chases.length; i++) {
      const chase = chases[i];
      if (chase === null) continue;
      follow(chase, aliens[i], hers, k);
      if (k < DEGREE)
        advance(aliens[i], times(chase.ux.get(k), rules.alienPull), times(chase.uy.get(k), rules.alienPull), k, unit);
    }
  }
  const turns = gun !== null && !lines.restsInTarget;
  const centrals = [gun, push, ...chases].filter((c) => c !== null);
  const moving = [hers, ...asteroids, ...aliens].filter((path) => !path.stands);
  const series = [...moving.flatMap((p) => [p.x, p.y, p.vx, p.vy]), ...centrals.flatMap((c) => [c.ux, c.uy])];
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
    besideCentre: Math.min(beside(target, lines.gun), beside(repulsor, lines.field)),
    centres: [gun, push].filter((c) => c !== null && c.along !== null && !isShort(c.along, 0.5)).map((c) => distanceAlong(c!)),
  };
}

const isMoving = ({ velocity }: Mover): boolean => velocity.x.hi !== 0 || velocity.y.hi !== 0;

/** Uniform motion, to which forces are added. */
const lineOf = ({ at, velocity }: Mover, unit: number): Path => ({
  x: Series.line(at.x, times(velocity.x, unit)),
  y: Series.line(at.y, times(velocity.y, unit)),
  vx: Series.line(velocity.x),
  vy: Series.line(velocity.y),
  stands: false,
});

const REST = Series.line(ZERO);
const STANDING = new WeakMap<Vector, Path>();

/** The path of what stands at a place. */
export function standing(at: Vector): Path {
  const known = STANDING.get(at);
  if (known !== undefined) return known;
  const path = { x: Series.line(at.x), y: Series.line(at.y), vx: REST, vy: REST, stands: true };
  STANDING.set(at, path);
  return path;
}

/** The sum of the winds that blow on her, px/s². */
function blowing({ level, winds }: World): Vector {
  return level.winds.reduce((sum, { ax, ay }, i) => (winds[i] ? plus(sum, vector(ax, ay)) : sum), NOWHERE);
}

interface Lines {
  readonly gun: Along;
  readonly field: Along;
  /** Whether she and the target rest in each other: then her box keeps its direction. */
  readonly restsInTarget: boolean;
}

/** On which lines through centres the motion is: these go through the centre, where a series has no meaning. */
function linesOf(world: World, target: Mover | null, repulsor: Mover | null, wind: Vector, recoil: number): Lines {
  const { her, rules } = world;
  const gun = target === null ? null : alongLine(her, target, wind);
  const field = repulsor === null ? null : alongLine(her, repulsor, wind);
  const isHeld = world.limits[0] !== 0 || world.limits[1] !== 0;
  let restsInTarget = false;
  let inGun = gun?.along ?? null;
  if (target !== null && gun?.rests === true) {
    if (isHeld || (repulsor !== null && field?.rests !== true)) throw new NotCovered('rests in the target beside other forces');
    const strongest = (repulsor === null ? rules.pull : 0) + recoil;
    restsInTarget = Math.hypot(wind.x.hi, wind.y.hi) <= strongest;
    if (!isShort(wind, NO_LENGTH)) {
      inGun = restsInTarget ? scaled(wind, divide(dd(-1), dd(strongest))) : direction(scaled(wind, dd(-1)));
    }
  }
  const inField = field?.along ?? null;
  // both act, or one of them turns about the other's line
  const bent = repulsor !== null && target !== null && inGun !== null && (inField === null || !isParallel(inGun, inField));
  if (bent && isShort(minus(target.at, her.at), NO_LENGTH)) throw new NotCovered('in the centre of the target beside its line');
  if (repulsor !== null && inField === null && isShort(minus(repulsor.at, her.at), NO_LENGTH)) {
    throw new NotCovered('in the centre of a field beside its line');
  }
  if (target !== null && inGun === null && isShort(minus(target.at, her.at), NO_LENGTH)) {
    throw new NotCovered('in the centre of the target beside its line');
  }
  return { gun: bent ? null : inGun, field: inField, restsInTarget };

  function alongLine(body: Mover, centre: Mover, steady: Vector): { along: Along; rests: boolean } {
    const u = minus(centre.at, body.at);
    const relative = minus(centre.velocity, body.velocity);
    const speed = Math.hypot(relative.x.hi, relative.y.hi);
    const isCentre = isShort(u, NO_LENGTH);
    const rests = isCentre && speed < NO_LENGTH;
    let along: Vector;
    if (rests) along = isShort(steady, NO_LENGTH) ? NOWHERE : direction(scaled(steady, dd(-1)));
    else along = direction(isCentre ? relative : u);
    // the impact parameter
    if (speed >= NO_LENGTH && Math.abs(cross(u, relative).hi) > NO_LENGTH * speed) return { along: null, rests };
    if (!isParallel(along, steady)) return { along: null, rests };
    const slanted = Math.abs(along.x.hi) > NO_LENGTH && Math.abs(along.y.hi) > NO_LENGTH;
    if (slanted && (world.limits[0] !== 0 || world.limits[1] !== 0)) return { along: null, rests };
    return { along, rests };
  }
}

const isParallel = (a: Vector, b: Vector): boolean =>
  Math.abs(cross(a, b).hi) <= 1e-22 * (Math.hypot(a.x.hi, a.y.hi) * Math.hypot(b.x.hi, b.y.hi));

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

const central = (along: Along): Central => {
  const none = along ?? NOWHERE;
  const [ux, uy] = along === null ? [new Series(), new Series()] : [Series.line(none.x), Series.line(none.y)];
  return { dx: new Series(), dy: new Series(), d2: new Series(), weighted: new Series(), inverse: new Series(), ux, uy, along };
};

/** Computes coefficient `k` of a central's series from those of the two paths. */
function follow(c: Central, body: Path, centre: Path, k: number): void {
  c.dx.set(k, subtract(centre.x.get(k), body.x.get(k)));
  c.dy.set(k, subtract(centre.y.get(k), body.y.get(k)));
  if (c.along !== null) return;
  c.d2.set(k, add(productAt(c.dx, c.dx, k), productAt(c.dy, c.dy, k)));
  c.weighted.set(k, times(c.d2.get(k), k / 2));
  c.inverse.set(k, inverseRootAt(c.d2, c.weighted, c.inverse, k));
  c.ux.set(k, productAt(c.dx, c.inverse, k));
  c.uy.set(k, productAt(c.dy, c.inverse, k));
}

/**
 * Coefficient `k` of f = 1 / sqrt(of), from `of` f' = -f of' / 2: the sum of (k - j / 2) of[j] f[k - j] over all j above 0 is
 * -k of[0] f[k]. `weighted` has j of[j] / 2.
 */
function inverseRootAt(of: Series, weighted: Series, f: Series, k: number): Dd {
  if (k === 0) return divide(ONE, squareRoot(of.get(0)));
  // f[k] is still 0, so that j = 0 adds nothing
  const sum = subtract(productAt(weighted, f, k), times(productAt(of, f, k), k));
  return multiply(divide(sum, of.get(0)), INVERSES[k]);
}

/** 1 / k. */
const INVERSES: readonly Dd[] = Array.from({ length: DEGREE + 2 }, (_, k) => (k === 0 ? ZERO : divide(ONE, dd(k))));

function advance(path: Path, ax: Dd, ay: Dd, k: number, unit: number): void {
  const by = times(INVERSES[k + 1], unit);
  path.vx.set(k + 1, multiply(ax, by));
  path.vy.set(k + 1, multiply(ay, by));
  if (k + 2 > DEGREE) return;
  const next = times(INVERSES[k + 2], unit);
  path.x.set(k + 2, multiply(path.vx.get(k + 1), next));
  path.y.set(k + 2, multiply(path.vy.get(k + 1), next));
}

/** How far along its line a centre is, px. */
function distanceAlong({ dx, dy, along }: Central): Series {
  const made = new Series();
  for (let k = 0; k <= DEGREE; k++) made.set(k, dot({ x: dx.get(k), y: dy.get(k) }, along!));
  return made;
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

import type { Level } from '../../../schema/basics/index.ts';
import {
  cross,
  type Dd,
  dd,
  direction,
  divide,
  dot,
  isShort,
  minus,
  multiply,
  NOWHERE,
  plus,
  roughLength,
  scaled,
  type Vector,
  vector,
  ZERO,
} from './double-double.ts';
import { NotCovered } from './stretch.ts';
import { type Mover, NO_LENGTH, placeOf, type World } from './world.ts';

/** What acts on her besides the gun. */
export interface Surroundings {
  /** The field that pushes her, instead of the gun's pull; null if none does. */
  readonly field: Mover | null;
  readonly wind: Vector;
}

/** What acts from now on, until something happens. */
export interface Acting {
  readonly target: Mover | null;
  readonly outside: Surroundings;
  /** While she slides on a rim: what acts inside of it; else the same as outside. */
  readonly inside: Surroundings;
  readonly lines: Lines;
  /** The pull's decrease with distance, 1/s². */
  readonly slope: Dd;
  /** How the target accelerates towards her, px/s²; 0 without recoil. */
  readonly recoil: Dd;
  /** Whether her box turns to the target. */
  readonly turns: boolean;
}

const NO_LINES: Lines = { gun: null, field: null, restsInTarget: false };

export function actingIn(world: World): Acting {
  const { level, rules, slide } = world;
  const outside = surroundings(world, false);
  const inside = slide === null ? outside : surroundings(world, true);
  const target = world.held && world.target >= 0 ? world.asteroids[world.target] : null;
  const hasRecoil = level.recoil && target !== null && rules.recoil > 0;
  const diameter = hasRecoil ? 2 * level.asteroids[world.target].radius : 1;
  const lines =
    slide === null ? linesOf(world, target, outside.field, outside.wind, hasRecoil ? rules.recoil / diameter : 0) : NO_LINES;
  return {
    target,
    outside,
    inside,
    lines,
    slope: divide(dd(rules.pull), dd(level.range)),
    recoil: hasRecoil ? divide(dd(rules.recoil), dd(diameter)) : ZERO,
    turns: target !== null && !lines.restsInTarget,
  };
}

/** What acts on her. @param isInside - whether the rim on which she slides counts as containing her, where she does */
function surroundings(world: World, isInside: boolean): Surroundings {
  const { level, slide } = world;
  const flags = (kind: 'field' | 'wind', list: readonly boolean[]) =>
    slide?.kind === kind ? list.map((flag, i) => (i === slide.index ? isInside : flag)) : list;
  const winds = flags('wind', world.winds);
  const wind = level.winds.reduce((sum, { ax, ay }, i) => (winds[i] ? plus(sum, vector(ax, ay)) : sum), NOWHERE);
  const field = flags('field', world.fields).indexOf(true);
  return { field: field < 0 ? null : { at: placeOf(level.repulsors[field]), velocity: NOWHERE }, wind };
}

/** The circle on whose rim she slides. */
export function rimOf({ level, slide }: World): Level['winds'][number] | Level['repulsors'][number] {
  return slide!.kind === 'field' ? level.repulsors[slide!.index] : level.winds[slide!.index];
}

/** How fast she moves away from the centre of a circle on whose rim she is, px/s. */
export const speedAcross = (at: Vector, velocity: Vector, centre: Vector, radius: number): number =>
  multiply(dot(minus(at, centre), velocity), divide(dd(1), dd(radius))).hi;

/** Whether a body is awake and chases her. */
export const chases = (alien: World['aliens'][number]): boolean => alien.awake && !alien.gone;

/** A line through the centre of a force: the direction to it stays the same. */
export type Along = Vector | null;

interface Lines {
  readonly gun: Along;
  readonly field: Along;
  /** Whether she and the target rest in each other: then her box keeps its direction. */
  readonly restsInTarget: boolean;
}

/** On which lines through centres the motion is: these go through the centre, where a series has no meaning. */
function linesOf(world: World, target: Mover | null, repulsor: Mover | null, wind: Vector, recoil: number): Lines {
  const { her, rules } = world;
  const isHeld = world.limits[0] !== 0 || world.limits[1] !== 0;
  const gun = target === null ? null : alongLine(her, target, wind);
  const field = repulsor === null ? null : alongLine(her, repulsor, wind);
  let restsInTarget = false;
  let inGun = gun?.along ?? null;
  if (target !== null && gun?.rests === true) {
    if (isHeld || (repulsor !== null && field?.rests !== true)) throw new NotCovered('rests in the target beside other forces');
    const strongest = (repulsor === null ? rules.pull : 0) + recoil;
    restsInTarget = roughLength(wind.x.hi, wind.y.hi) <= strongest;
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
    const speed = roughLength(relative.x.hi, relative.y.hi);
    const isCentre = isShort(u, NO_LENGTH);
    const rests = isCentre && speed < NO_LENGTH;
    let along: Vector;
    if (rests) along = isShort(steady, NO_LENGTH) ? NOWHERE : direction(scaled(steady, dd(-1)));
    else along = direction(isCentre ? relative : u);
    // the impact parameter
    if (speed >= NO_LENGTH && Math.abs(cross(u, relative).hi) > NO_LENGTH * speed) return { along: null, rests };
    // held on both axes she flies straight on, whatever acts
    if (world.limits[0] !== 0 && world.limits[1] !== 0) return { along, rests };
    const isSlanted = Math.abs(along.x.hi) > NO_LENGTH && Math.abs(along.y.hi) > NO_LENGTH;
    return { along: isParallel(along, steady) && !(isSlanted && isHeld) ? along : null, rests };
  }
}

const isParallel = (a: Vector, b: Vector): boolean =>
  Math.abs(cross(a, b).hi) <= 1e-22 * (roughLength(a.x.hi, a.y.hi) * roughLength(b.x.hi, b.y.hi));

/** About the time in which the nearest centre that is not on a line is reached, s. */
export function timeToCentre({ her, aliens, rules }: World, { target, inside, outside, lines }: Acting): number {
  let least = Number.POSITIVE_INFINITY;
  const consider = (a: Mover, b: Mover, acceleration: number) => {
    const u = minus(a.at, b.at);
    const v = minus(a.velocity, b.velocity);
    const d = roughLength(u.x.hi, u.y.hi);
    least = Math.min(least, d / (roughLength(v.x.hi, v.y.hi) + Math.sqrt(acceleration * d)));
  };
  const strength = rules.pull + rules.push + 200;
  const field = inside.field ?? outside.field;
  if (target !== null && lines.gun === null) consider(target, her, strength);
  if (field !== null && lines.field === null) consider(field, her, strength);
  for (const alien of aliens) if (chases(alien)) consider(alien, her, strength + rules.alienPull);
  return least;
}

import { cross, dd, direction, divide, isShort, minus, NOWHERE, scaled, type Vector } from './double-double.ts';
import { NotCovered } from './not-covered.ts';
import { type Mover, NO_LENGTH, type World } from './world.ts';

/** A line through the centre of a force: the direction to it stays the same. */
export type Along = Vector | null;

export interface Lines {
  readonly gun: Along;
  readonly field: Along;
  /** Whether she and the target rest in each other: then her box keeps its direction. */
  readonly restsInTarget: boolean;
}

/** On which lines through centres the motion is: these go through the centre, where a series has no meaning. */
export function linesOf(world: World, target: Mover | null, repulsor: Mover | null, wind: Vector, recoil: number): Lines {
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

import type { Place, Rules } from '../../schema/basics/index.ts';
import { apart } from './geometry.ts';

/** All places, or velocities, within a distance of a centre. */
interface Ball {
  readonly centre: Place;
  readonly within: number;
}

/**
 * Where an alien may be and how fast. An alien that may have exploded is not certainly there; but while it may be there, it may
 * explode others.
 */
export interface Chaser {
  /** Possible places, px. */
  readonly at: Ball;
  /** Possible velocities, px/s. */
  readonly speed: Ball;
  /** Radius of its circle, px. */
  readonly radius: number;
  /** Whether it is certainly there. */
  readonly isThere: boolean;
}

interface Area {
  readonly left: number;
  readonly right: number;
  readonly low: number;
  readonly high: number;
}

const ROUNDING = 1e-7;
const ORIGIN: Place = { x: 0, y: 0 };

/**
 * Lemma `chasers`: where aliens may be after some seconds, while she is anywhere in an area.
 *
 * An alien accelerates towards her by a fixed amount while she is closer than it sees, and stops dead at any moment when she is
 * not. So its place and velocity lie in discs that follow from its earlier ones and from the places where she may be. The speed
 * limit does not apply to aliens in continuous time. Two aliens that touch explode, so one is certainly there only if no other
 * can have touched it.
 */
export function afterChase(rules: Rules, chasers: readonly Chaser[], area: Area, seconds: number): readonly Chaser[] {
  const farthest = (c: Chaser) =>
    c.at.within +
    (apart(c.speed.centre, ORIGIN) + c.speed.within) * seconds +
    (rules.alienPull * seconds * seconds) / 2 +
    ROUNDING;
  // Two that touch explode.
  const mayMeet = (a: Chaser, b: Chaser) => apart(a.at.centre, b.at.centre) <= farthest(a) + farthest(b) + a.radius + b.radius;
  return chasers.map((chaser) => {
    const isThere = chaser.isThere && !chasers.some((other) => other !== chaser && mayMeet(chaser, other));
    return { ...moved(rules, chaser, area, seconds, farthest(chaser)), isThere };
  });
}

/** An alien that cannot see her stands still, or has stopped dead; otherwise it is drawn towards her. */
function moved(
  { alienPull, alienSight }: Rules,
  chaser: Chaser,
  { left, right, low, high }: Area,
  seconds: number,
  own: number,
): Chaser {
  const her: Ball = {
    centre: { x: (left + right) / 2, y: (low + high) / 2 },
    within: apart({ x: left, y: low }, { x: right, y: high }) / 2,
  };
  const { at, speed } = chaser;
  const d = apart(her.centre, at.centre);
  const stands = speed.within === 0 && speed.centre.x === 0 && speed.centre.y === 0;
  if (stands && d - her.within - at.within > alienSight + ROUNDING) return chaser;
  const blur = her.within + own;
  const anyPull: Ball = { centre: ORIGIN, within: alienPull };
  const share = alienPull / d;
  const towards: Ball = {
    centre: { x: share * (her.centre.x - at.centre.x), y: share * (her.centre.y - at.centre.y) },
    // If the sine of an angle is at most 1/2, its chord is at most 1.04 times the sine.
    within: 1.1 * share * blur,
  };
  const maySleep = d + blur >= alienSight - ROUNDING;
  const pulled = 2 * blur > d ? anyPull : maySleep ? orNothing(towards) : towards;
  const a = pulled.within > alienPull ? anyPull : pulled;
  const v = maySleep ? orNothing(speed) : speed;
  const after = (p: Ball, by: Ball, times: number): Ball => ({
    centre: { x: p.centre.x + by.centre.x * times, y: p.centre.y + by.centre.y * times },
    within: p.within + by.within * times + ROUNDING / 2,
  });
  return { ...chaser, at: after(after(at, v, seconds), a, (seconds * seconds) / 2), speed: after(v, a, seconds) };
}

/** A disc that contains another one and the origin. */
const orNothing = ({ centre, within }: Ball): Ball => ({
  centre: { x: centre.x / 2, y: centre.y / 2 },
  within: within + apart(centre, ORIGIN) / 2,
});

/** An alien that may be either of two. */
export function eitherChaser(a: Chaser, b: Chaser): Chaser {
  if (a === b) return a;
  return { ...a, at: eitherBall(a.at, b.at), speed: eitherBall(a.speed, b.speed), isThere: a.isThere && b.isThere };
}

function eitherBall(a: Ball, b: Ball): Ball {
  const d = apart(a.centre, b.centre);
  if (d + b.within <= a.within) return a;
  if (d + a.within <= b.within) return b;
  const within = (a.within + b.within + d) / 2;
  const part = (within - a.within) / d;
  return {
    centre: { x: a.centre.x + part * (b.centre.x - a.centre.x), y: a.centre.y + part * (b.centre.y - a.centre.y) },
    within: within + 1e-12,
  };
}

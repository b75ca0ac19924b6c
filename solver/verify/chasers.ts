import type { Rules } from '../../schema/index.ts';
import { apart, type Point } from './rounded.ts';

/** All places, or velocities, within a distance of a centre. */
interface Disc {
  readonly centre: Point;
  readonly within: number;
}

/**
 * An alien: where it may be and how fast, if it is there at all. It is not there for certain once it may have exploded, but as long as it may be there it may
 * explode another.
 */
export interface Chaser {
  readonly at: Disc;
  readonly speed: Disc;
  /** of its circle, px */
  readonly radius: number;
  readonly isThere: boolean;
}

interface Area {
  readonly left: number;
  readonly right: number;
  readonly low: number;
  readonly high: number;
}

const ROUNDING = 1e-7;
const ORIGIN: Point = { x: 0, y: 0 };

/** What becomes of aliens in some seconds in which she is anywhere in an area, by a game's rules. */
export function afterChase(rules: Rules, chasers: readonly Chaser[], area: Area, seconds: number): readonly Chaser[] {
  const farthest = (c: Chaser) =>
    c.at.within +
    (apart(c.speed.centre, ORIGIN) + c.speed.within) * seconds +
    (rules.alienPull * seconds * seconds) / 2 +
    ROUNDING;
  // two that touch explode
  const mayMeet = (a: Chaser, b: Chaser) => apart(a.at.centre, b.at.centre) <= farthest(a) + farthest(b) + a.radius + b.radius;
  return chasers.map((chaser) => {
    const isThere = chaser.isThere && !chasers.some((other) => other !== chaser && mayMeet(chaser, other));
    return { ...moved(rules, chaser, area, seconds, farthest(chaser)), isThere };
  });
}

/** One that she is farther from than it sees stands still, and has stopped dead when it did not; otherwise it is drawn to her. */
function moved(
  { alienPull, alienSight }: Rules,
  chaser: Chaser,
  { left, right, low, high }: Area,
  seconds: number,
  own: number,
): Chaser {
  const her: Disc = {
    centre: { x: (left + right) / 2, y: (low + high) / 2 },
    within: apart({ x: left, y: low }, { x: right, y: high }) / 2,
  };
  const { at, speed } = chaser;
  const d = apart(her.centre, at.centre);
  const stands = speed.within === 0 && speed.centre.x === 0 && speed.centre.y === 0;
  if (stands && d - her.within - at.within > alienSight + ROUNDING) return chaser;
  const blur = her.within + own;
  const anyPull: Disc = { centre: ORIGIN, within: alienPull };
  const share = alienPull / d;
  const towards: Disc = {
    centre: { x: share * (her.centre.x - at.centre.x), y: share * (her.centre.y - at.centre.y) },
    // the chord of an angle whose sine is at most a half is at most 1.04 times that sine
    within: 1.1 * share * blur,
  };
  const maySleep = d + blur >= alienSight - ROUNDING;
  const pulled = 2 * blur > d ? anyPull : maySleep ? orNothing(towards) : towards;
  const a = pulled.within > alienPull ? anyPull : pulled;
  const v = maySleep ? orNothing(speed) : speed;
  const after = (p: Disc, by: Disc, times: number): Disc => ({
    centre: { x: p.centre.x + by.centre.x * times, y: p.centre.y + by.centre.y * times },
    within: p.within + by.within * times + ROUNDING / 2,
  });
  return { ...chaser, at: after(after(at, v, seconds), a, (seconds * seconds) / 2), speed: after(v, a, seconds) };
}

/** A disc that holds another and the origin. */
const orNothing = ({ centre, within }: Disc): Disc => ({
  centre: { x: centre.x / 2, y: centre.y / 2 },
  within: within + apart(centre, ORIGIN) / 2,
});

/** An alien that may be either of two. */
export function eitherChaser(a: Chaser, b: Chaser): Chaser {
  if (a === b) return a;
  return { ...a, at: eitherDisc(a.at, b.at), speed: eitherDisc(a.speed, b.speed), isThere: a.isThere && b.isThere };
}

function eitherDisc(a: Disc, b: Disc): Disc {
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

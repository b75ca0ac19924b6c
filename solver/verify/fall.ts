import { TICK, TICK_RATE } from '../../engine/index.ts';

/** The relative error of one floating-point operation; slightly more than 2^-53. */
const ROUNDING = 1.2e-16;

/** A fall from rest towards a centre, along a line that is parallel to neither axis. */
export interface Fall {
  /** Distance from the start to the centre, px. */
  readonly centre: number;
  /** The least distance to the centre at an observation at which the run goes on, px. */
  readonly nearest: number;
  /** The longest jump between two observations, px. */
  readonly jump: number;
  /** The largest coordinate of a place, px. */
  readonly coordinate: number;
  /** The greatest acceleration of her or of the asteroid, px/s². */
  readonly push: number;
  /** Her greatest speed, px/s. */
  readonly speed: number;
  /** Length of the longest run, s. */
  readonly seconds: number;
  /** With recoil, the greatest speed of the asteroid, px/s, and how far it may move, px; 0 when it stands still. */
  readonly rockSpeed: number;
  readonly drift: number;
}

/**
 * Lemma `arcade-fall`: how far from her line rounding can take her while she falls frame by frame, px, and how far it can turn
 * her direction there, as a slope.
 *
 * Let r be the vector from the centre to her, and w her velocity. A frame is r += w dt, w += a dt, where a points along -r. So
 * the angular momentum r x w grows at most by the factor 1 + dt² |a| / |r| per frame. All |a| dt together are at most her
 * speed, and |r| is at least `nearest`, so all factors together are at most exp(speed dt / nearest), which is below 3 when
 * `nearest` is a jump or more. Rounding adds to the angular momentum in each frame: the error of a place times the speed, plus
 * the error of a velocity times the distance. The slope e / p, with e beside the line and p before the centre, changes in a
 * frame by dt times the angular momentum / (p p').
 *
 * With recoil, r is the vector from the asteroid to her. Both are moved first and pushed then, along r, so all of this holds
 * for r. The asteroid itself is pushed off its line by no more than the slope times the distance that it may move.
 */
export function offLine(fall: Fall): { beside: number; slope: number } {
  const { centre, nearest, coordinate, push, seconds, rockSpeed, drift } = fall;
  const speed = fall.speed + rockSpeed;
  const jump = fall.jump + rockSpeed * TICK;
  const last = nearest - jump;
  if (!(last >= 1)) return { beside: Number.POSITIVE_INFINITY, slope: Number.POSITIVE_INFINITY };
  const frames = Math.ceil(seconds * TICK_RATE) + 2;
  // A place: the product and the sum on both axes. A velocity likewise, and the pull: differences, root, quotient and products.
  const bodies = rockSpeed > 0 ? 2 : 1;
  const place = 3 * bodies * ROUNDING * (coordinate + drift + jump);
  const velocity = 3 * bodies * ROUNDING * (speed + 1) + 12 * bodies * ROUNDING * push * TICK;
  const momentum = 3 * frames * (place * speed + velocity * centre);
  const slope = frames * ((TICK * momentum) / (nearest * last) + (3 * place) / last);
  const beside = (centre + drift) * slope;
  // At the last observation she may be as near as `last`.
  return { beside, slope: slope + (beside + TICK * momentum) / last };
}

import { TICK, TICK_RATE } from '../../engine/index.ts';

/** What one operation on doubles may add, as a share of its result; a little more than 2^-53. */
const ROUNDING = 1.2e-16;

/** A fall from rest towards a centre, along a line that is parallel to neither axis; px, s, px/s. */
export interface Fall {
  /** from the start to the centre */
  readonly centre: number;
  /** how near she comes to it at a look at which the run goes on */
  readonly nearest: number;
  /** the farthest from one look to the next */
  readonly jump: number;
  /** the largest number of a place */
  readonly coordinate: number;
  /** the most that anything accelerates her or the asteroid, px/s2 */
  readonly push: number;
  /** the fastest she can be */
  readonly speed: number;
  /** longest run */
  readonly seconds: number;
  /** recoil of the asteroid: how fast it may become, and how far it may come; 0 where it stands still */
  readonly rockSpeed: number;
  readonly drift: number;
}

/**
 * Lemma `arcade-fall`: how far from her line rounding can take her while she falls frame by frame, px, and by how much it can turn her there, as a slope.
 *
 * With r from the centre to her and w her velocity, a frame is r += w dt, w += a dt, and a points along -r: the momentum r x w grows by no more than the
 * factor 1 + dt2 |a| / |r|. All |a| dt together are at most her speed, and |r| is at least `nearest`: all factors together at most exp(speed dt / nearest), which is
 * below 3 where `nearest` is a jump or more. Rounding adds to the momentum, in each frame, what it takes from a place times the speed, and what it
 * takes from a velocity times the distance. The slope e / p, e beside the line and p before the centre, changes in a frame by dt times the momentum / (p p').
 * With recoil r is from the asteroid to her: both are moved first and pushed then, along r, so all of it holds for r; the asteroid itself is pushed off its
 * line by no more than the slope, as a share of the way it may come.
 */
export function offLine(fall: Fall): { beside: number; slope: number } {
  const { centre, nearest, coordinate, push, seconds, rockSpeed, drift } = fall;
  const speed = fall.speed + rockSpeed;
  const jump = fall.jump + rockSpeed * TICK;
  const last = nearest - jump;
  if (!(last >= 1)) return { beside: Number.POSITIVE_INFINITY, slope: Number.POSITIVE_INFINITY };
  const frames = Math.ceil(seconds * TICK_RATE) + 2;
  // a place: the product, the sum, both axes; a velocity likewise; and the pull: differences, root, quotient, products
  const bodies = rockSpeed > 0 ? 2 : 1;
  const place = 3 * bodies * ROUNDING * (coordinate + drift + jump);
  const velocity = 3 * bodies * ROUNDING * (speed + 1) + 12 * bodies * ROUNDING * push * TICK;
  const momentum = 3 * frames * (place * speed + velocity * centre);
  const slope = frames * ((TICK * momentum) / (nearest * last) + (3 * place) / last);
  const beside = (centre + drift) * slope;
  // at the last look she may be as near as `last`
  return { beside, slope: slope + (beside + TICK * momentum) / last };
}

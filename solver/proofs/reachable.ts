import type { Level } from '../../schema/index.ts';
import { distance, surelyLess } from './rounding.ts';

/** More comparisons than this and every asteroid counts as one she can come to: too kind to the level, never wrong. */
const MOST_COMPARISONS = 4_000_000;

/**
 * The asteroids she can ever be in range of: those in range of the start, and so on from range to range.
 * @param drift how far each may be moved, px
 * @param jump how wide a gap she may jump, px
 */
export function reachableAsteroids(
  { asteroids, astronaut, range }: Level,
  drift: readonly number[],
  jump: number,
): readonly number[] {
  const reached: number[] = [];
  let waiting = [...asteroids.keys()];
  const take = (near: (i: number) => boolean) => {
    const left: number[] = [];
    for (const i of waiting) (near(i) ? reached : left).push(i);
    waiting = left;
  };
  // what is in range of the start isn't drifting yet; with the drift the claim is simpler, and hardly weaker
  take((i) => !surelyLess(range + drift[i], distance(asteroids[i], astronaut)));
  let comparisons = 0;
  for (let next = 0; next < reached.length && waiting.length > 0; next++) {
    comparisons += waiting.length;
    if (comparisons > MOST_COMPARISONS) return [...asteroids.keys()];
    const from = reached[next];
    take((i) => !surelyLess(2 * range + drift[i] + drift[from] + jump, distance(asteroids[i], asteroids[from])));
  }
  return reached.sort((a, b) => a - b);
}

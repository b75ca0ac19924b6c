import type { Level } from '../../schema/index.ts';
import { exitOf, mouthDiscs } from './rims.ts';
import { distance, surelyLess } from './rounding.ts';

/** More comparisons than this and every asteroid counts as one she can come to: too kind to the level, never wrong. */
const MOST_COMPARISONS = 4_000_000;

/** What she can ever come to, by index, ascending. */
export interface Reachable {
  /** those she can be in range of */
  readonly asteroids: readonly number[];
  /** mouths of wormholes that she can come into */
  readonly mouths: readonly number[];
}

/**
 * The asteroids she can ever be in range of: those in range of the start, and so on from range to range, and through wormholes.
 * @param drift how far each may be moved, px
 * @param jump how wide a gap she may jump, px
 */
export function reachable(level: Level, drift: readonly number[], jump: number): Reachable {
  const { asteroids, astronaut, range } = level;
  const mouths = mouthDiscs(level);
  const reached: number[] = [];
  const entered: number[] = [];
  let waiting = [...asteroids.keys()];
  const take = (near: (i: number) => boolean) => {
    const left: number[] = [];
    for (const i of waiting) (near(i) ? reached : left).push(i);
    waiting = left;
  };
  // what is in range of the start isn't drifting yet; with the drift the claim is simpler, and hardly weaker
  take((i) => !surelyLess(range + drift[i], distance(asteroids[i], astronaut)));
  let comparisons = 0;
  const isTooMuch = (more: number): boolean => {
    comparisons += more;
    return comparisons > MOST_COMPARISONS;
  };
  const all: Reachable = { asteroids: [...asteroids.keys()], mouths: [...mouths.keys()] };
  for (let next = 0; ; ) {
    for (; next < reached.length && waiting.length > 0; next++) {
      if (isTooMuch(waiting.length)) return all;
      const from = reached[next];
      take((i) => !surelyLess(2 * range + drift[i] + drift[from] + jump, distance(asteroids[i], asteroids[from])));
    }
    const mouth = nextMouth();
    if (mouth === null) break;
    entered.push(mouth);
    const exit = mouths[exitOf(mouth)];
    if (isTooMuch(waiting.length)) return all;
    take((i) => !surelyLess(range + drift[i] + exit.radius + jump, distance(asteroids[i], exit)));
  }
  return { asteroids: reached.sort((a, b) => a - b), mouths: entered.sort((a, b) => a - b) };

  /** A mouth that she comes to from what she has come to so far. */
  function nextMouth(): number | null {
    for (const [m, mouth] of mouths.entries()) {
      if (entered.includes(m)) continue;
      comparisons += reached.length + entered.length;
      const inRange = (i: number) => !surelyLess(range + drift[i] + mouth.radius + jump, distance(asteroids[i], mouth));
      const besideExit = (n: number) => {
        const exit = mouths[exitOf(n)];
        return !surelyLess(exit.radius + mouth.radius + 2 * jump, distance(exit, mouth));
      };
      if (comparisons > MOST_COMPARISONS || reached.some(inRange) || entered.some(besideExit)) return m;
    }
    return null;
  }
}

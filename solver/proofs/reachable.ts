import type { Level } from '../../schema/basics/index.ts';
import { exitOf, mouthDiscs } from './rims.ts';
import { distance, surelyLess } from './rounding.ts';

/** Beyond this many comparisons every asteroid counts as reachable, which may lose a proof but is never wrong. */
const MOST_COMPARISONS = 4_000_000;

/** What she can ever reach: indices, ascending. */
export interface Reachable {
  /** The asteroids whose range she can enter. */
  readonly asteroids: readonly number[];
  /** The mouths of wormholes that she can enter. */
  readonly mouths: readonly number[];
}

/**
 * Finds the asteroids whose range she can ever enter: those in range of the start, and from there on through overlapping ranges
 * and wormholes (a search over a graph).
 * @param drift how far each asteroid may move, px
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
  // Nothing has drifted at the start. Including the drift makes the claim simpler and hardly weaker.
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

  /** A mouth that she can enter from what she has reached so far. */
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

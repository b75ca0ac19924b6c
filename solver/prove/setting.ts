import {
  type AccuracyName,
  type Box,
  boxOf,
  compile,
  createSimulation,
  DEFAULT_MAX_TIME,
  TICK,
  TICK_RATE,
  unlimited,
  type WorkBudget,
} from '../../engine/index.ts';
import { type Disc, type Level, type Rules, rulesOf } from '../../schema/basics/index.ts';
import { createRandom } from '../random.ts';
import { driftWithin, effectsOf, fastestFrame, speedAfter, strongestPush } from './assumptions.ts';
import { distance, surelyLess } from './rounding.ts';

/** A circle around (x, y), px from the start. */
export interface Spot {
  readonly x: number;
  readonly y: number;
  readonly r: number;
}

/** The accuracies with swept contacts: her path is continuous, and no contact on it is missed. */
export const CONTINUOUS: readonly AccuracyName[] = ['fast', 'standard', 'precise'];

/** The accuracies whose error is below every margin of a proof, so that what is true of the exact motion is true of them. */
export const EXACT: readonly AccuracyName[] = ['precise'];

/** Every accuracy. */
export const ALL_ACCURACIES: readonly AccuracyName[] = ['arcade', ...CONTINUOUS];

/** The numbers that all proofs about a level share. Places are relative to her start. */
export interface Setting {
  readonly level: Level;
  /** Names of the effects that the level calls for. */
  readonly effects: readonly string[];
  /** The rules of the level. */
  readonly rules: Rules;
  readonly box: Box;
  /** Her box certainly overlaps a circle when her centre is closer to its centre than its radius plus this, px. */
  readonly leastHalf: number;
  /** The greatest possible acceleration, px/s². */
  readonly strongest: number;
  /** Length of the longest run, s. */
  readonly maxTime: number;
  /**
   * How far she can jump between two observations, px: 0 in continuous time, one frame's flight in `arcade`. It is bounded by
   * an energy bound on her speed anywhere in range, v² <= v0² + 2 a s for the acceleration a and the distance s. With wormholes
   * she may fall the same distance again and again, so the speed limit is the bound.
   */
  readonly jump: number;
  /** How far recoil can carry each asteroid, px: a t² / 2, as if it were pulled all the time. */
  readonly drift: readonly number[];
  /** What she can ever reach. */
  readonly reached: Reachable;
  /** Limits the work of the provers. */
  readonly budget: WorkBudget;
  /** Length of the longest random play, s; null when one lasts longer than `most` seconds or completes the level. */
  longestPlay(most: number): number | null;
}

/** Computes the numbers of a level, for frames or for continuous time. */
export function settingOf(level: Level, maxTime: number | null, frames: boolean, budget: WorkBudget = unlimited()): Setting {
  const time = maxTime ?? DEFAULT_MAX_TIME;
  const rules = rulesOf(level);
  const box = boxOf(rules);
  // Frames go slightly farther than continuous time.
  const square = frames ? (time + TICK) * (time + 2 * TICK) : time * time;
  const drift = level.asteroids.map((_, i) => driftWithin({ level, rules }, i, square));
  const strongest = strongestPush(level, rules);
  const jump = frames ? frameJump(level, drift, strongest, fastestFrame(rules)) : 0;
  // Expensive in large levels and not needed by every prover, so computed on demand.
  let reached: Reachable | null = null;
  const plays = longestPlays(level, budget);
  return {
    level,
    effects: effectsOf(level),
    rules,
    box,
    leastHalf: Math.min(box.halfWidth, box.halfHeight),
    strongest,
    maxTime: time,
    drift,
    jump,
    budget,
    longestPlay: plays,
    get reached() {
      reached ??= reachable(level, drift, jump);
      return reached;
    },
  };
}

function frameJump(
  { asteroids, range, astronaut, wormholes }: Level,
  drift: readonly number[],
  strongest: number,
  fastest: number,
): number {
  if (wormholes.length > 0) return fastest;
  let left = 0;
  let right = 0;
  let top = 0;
  let bottom = 0;
  for (const [i, { x, y }] of asteroids.entries()) {
    const r = range + drift[i];
    left = Math.min(left, x - astronaut.x - r);
    right = Math.max(right, x - astronaut.x + r);
    top = Math.min(top, y - astronaut.y - r);
    bottom = Math.max(bottom, y - astronaut.y + r);
  }
  const across = right - left + 2 * fastest;
  const down = bottom - top + 2 * fastest;
  const way = Math.sqrt(across * across + down * down);
  const start = astronaut.vx * astronaut.vx + astronaut.vy * astronaut.vy;
  return Math.min(fastest, speedAfter(strongest, way, start) * TICK * 1.001);
}

/** The object that a proof is about, px from the start. */
export interface Thing {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  /** Whenever her box touches the object, her centre is closer to its centre than this, px. */
  readonly touch: number;
}

/** The object that a proof is about, made from a circle of the level. */
export function thingOf(level: Level, { x, y, radius }: { x: number; y: number; radius: number }): Thing {
  const { astronaut } = level;
  return { x: x - astronaut.x, y: y - astronaut.y, radius, touch: radius + boxOf(rulesOf(level)).halfDiagonal };
}

/** Beyond this many comparisons every asteroid counts as reachable, which may lose a proof but is never wrong. */
const MOST_COMPARISONS = 4_000_000;

/** What she can ever reach: indices, ascending. */
interface Reachable {
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
function reachable(level: Level, drift: readonly number[], jump: number): Reachable {
  const { asteroids, astronaut, range } = level;
  const mouths = mouthDiscs(level);
  const reached: number[] = [];
  const entered: number[] = [];
  const isEntered = new Uint8Array(mouths.length);
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
    isEntered[mouth] = 1;
    const exit = mouths[exitOf(mouth)];
    if (isTooMuch(waiting.length)) return all;
    take((i) => !surelyLess(range + drift[i] + exit.radius + jump, distance(asteroids[i], exit)));
  }
  return { asteroids: reached.sort((a, b) => a - b), mouths: entered.sort((a, b) => a - b) };

  /** A mouth that she can enter from what she has reached so far. */
  function nextMouth(): number | null {
    for (const [m, mouth] of mouths.entries()) {
      if (isEntered[m] === 1) continue;
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

/** Whether she moves at the start, or a field or a wind moves her at once. At rest she can wait for any time. */
export const startsMoving = ({ astronaut, repulsors, winds }: Level): boolean =>
  astronaut.vx !== 0 ||
  astronaut.vy !== 0 ||
  [...repulsors, ...winds].some((field) => distance(field, astronaut) <= field.radius);

/** Random plays that are sampled. */
const PLAYS = 120;

/**
 * Returns a function that tells the length of the longest of some random plays, s, from which provers guess how far they have to
 * follow her; null when one lasts longer than `most` seconds or completes the level, so that following all plays is hopeless.
 * Several provers ask, so the plays are played again only for more seconds than before.
 */
function longestPlays(level: Level, budget: WorkBudget): (most: number) => number | null {
  let asked = 0;
  let known: number | null = null;
  return (most) => {
    if (known === null && most > asked) {
      known = longestPlay(level, most, budget);
      asked = most;
    }
    return known !== null && known <= most ? known : null;
  };
}

function longestPlay(level: Level, most: number, budget: WorkBudget): number | null {
  const simulation = createSimulation(compile(level), budget);
  const random = createRandom(0);
  const last = Math.floor(most * TICK_RATE);
  let longest = 0;
  for (let play = 0; play < PLAYS; play++) {
    simulation.reset();
    let held = play % 2 === 1;
    // The first two plays are an endless hold and an endless drift.
    const piece = play < 2 ? last : 8 << (play % 4);
    while (simulation.ending === null && simulation.tick < last) {
      simulation.advance(play < 2 ? piece : 1 + random.below(piece), held);
      held = !held;
    }
    if (simulation.ending === null || simulation.ending.outcome === 'completed') return null;
    longest = Math.max(longest, simulation.ending.time);
  }
  return longest;
}

/** The mouths of all wormholes: number 2 i lies at (x, y) of wormhole i, number 2 i + 1 at its other end. */
export const mouthDiscs = ({ wormholes }: Level): readonly Disc[] =>
  wormholes.flatMap(({ x, y, toX, toY, radius }) => [
    { x, y, radius },
    { x: toX, y: toY, radius },
  ]);

/** The mouth at the other end of the same wormhole. */
export const exitOf = (mouth: number): number => (mouth % 2 === 0 ? mouth + 1 : mouth - 1);

/** The discs of winds and mouths. Provers that follow neither keep clear of all of them. */
export const rimDiscs = (level: Level): readonly Disc[] => [...level.winds, ...mouthDiscs(level)];

/** How late the engine may notice that she crosses a rim, px, and a little more. */
export const RIM_SLACK = 2e-6;

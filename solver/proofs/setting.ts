import { type AccuracyName, type Box, boxOf, DEFAULT_MAX_TIME, TICK, unlimited, type WorkBudget } from '../../engine/index.ts';
import { type Level, type Rules, rulesOf } from '../../schema/basics/index.ts';
import { driftWithin, effectsOf, fastestFrame, speedAfter, strongestPush } from './assumptions.ts';
import { type Reachable, reachable } from './reachable.ts';
import { longestPlays } from './soon-over.ts';

/** A circle around (x, y), px from the start. */
export interface Disc {
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

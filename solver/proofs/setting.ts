import { type AccuracyName, type Box, boxOf, DEFAULT_MAX_TIME, TICK, unlimited, type WorkBudget } from '../../engine/index.ts';
import { type Level, type Rules, rulesOf } from '../../schema/index.ts';
import { driftWithin, effectsOf, fastestFrame, speedAfter, strongestPush } from './assumptions.ts';
import { type Reachable, reachable } from './reachable.ts';

/** A circle about (x, y), px from the start. */
export interface Disc {
  readonly x: number;
  readonly y: number;
  readonly r: number;
}

/** The accuracies with swept contacts: whoever plays them, her way is continuous and no contact on it is missed. */
export const CONTINUOUS: readonly AccuracyName[] = ['fast', 'standard', 'precise'];

/** Those whose error is held below every margin of a proof, so that what is true of the game is true of them. */
export const EXACT: readonly AccuracyName[] = ['precise'];

/** Every accuracy. */
export const ALL_ACCURACIES: readonly AccuracyName[] = ['arcade', ...CONTINUOUS];

/** The numbers that proofs about a level share, places relative to her start. */
export interface Setting {
  readonly level: Level;
  /** the names of the effects that the level calls for */
  readonly effects: readonly string[];
  /** the game's numbers in this level */
  readonly rules: Rules;
  readonly box: Box;
  /** her box touches a circle for certain when her centre is nearer to its centre than its radius and this, px */
  readonly leastHalf: number;
  /** the most that anything can accelerate her, px/s2 */
  readonly strongest: number;
  /** longest run, s */
  readonly maxTime: number;
  /**
   * How far she can jump between two looks at the range and at contacts, px: 0 in continuous time, a frame's flight in `arcade`.
   * A bound, from the fastest she can be anywhere in range: speed 2 a s for the acceleration a and the way s from where she was. Through wormholes
   * she may fall the same way again and again.
   */
  readonly jump: number;
  /** how far recoil can carry each asteroid, px; the bound a t2 / 2 for an asteroid that is pulled all the time */
  readonly drift: readonly number[];
  /** what she can ever come to */
  readonly reached: Reachable;
  /** what looking for proofs may cost */
  readonly budget: WorkBudget;
}

/** The numbers of a level for one of the two ways of playing. */
export function settingOf(level: Level, maxTime: number | null, frames: boolean, budget: WorkBudget = unlimited()): Setting {
  const time = maxTime ?? DEFAULT_MAX_TIME;
  const rules = rulesOf(level);
  const box = boxOf(rules);
  // frames step a little farther than the flow
  const square = frames ? (time + TICK) * (time + 2 * TICK) : time * time;
  const drift = level.asteroids.map((_, i) => driftWithin({ level, rules }, i, square));
  const strongest = strongestPush(level, rules);
  const jump = frames ? frameJump(level, drift, strongest, fastestFrame(rules)) : 0;
  // dear in large levels, and of use to many proofs or to none
  let reached: Reachable | null = null;
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

/** The thing a proof is about, px from the start. */
export interface Thing {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  /** her centre is nearer than this to the thing's centre whenever her box touches it, px */
  readonly touch: number;
}

/** A circle of the level as the thing a proof is about. */
export function thingOf(level: Level, { x, y, radius }: { x: number; y: number; radius: number }): Thing {
  const { astronaut } = level;
  return { x: x - astronaut.x, y: y - astronaut.y, radius, touch: radius + boxOf(rulesOf(level)).halfDiagonal };
}

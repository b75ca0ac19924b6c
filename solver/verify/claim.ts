import { type Box, boxOf, DEFAULT_MAX_TIME, TICK } from '../../engine/index.ts';
import { type Level, type Rules, rulesOf } from '../../schema/index.ts';
import type { About } from '../proofs/index.ts';
import { driftIn, longestFrame, mostPush } from './assumptions.ts';

/**
 * What a certificate is checked against: places relative to her start (the start is 0, 0), and the few numbers on which
 * the arguments rest.
 */
export interface Claim {
  readonly level: Level;
  /** The game's numbers in it. */
  readonly rules: Rules;
  readonly box: Box;
  /** Her box holds a circle of this radius about its centre, px. */
  readonly inner: number;
  readonly about: About;
  /** The thing that is said to be out of reach. */
  readonly thing: { readonly x: number; readonly y: number; readonly radius: number };
  /** Her centre is nearer than this to the thing's centre whenever her box touches it, px. */
  readonly touch: number;
  /** Nothing accelerates her by more, px/s2. */
  readonly push: number;
  /**
   * Frames: she is looked at once a frame only (`arcade`), so that between two looks she may jump. Otherwise her way is
   * continuous and every contact on it is found.
   */
  readonly frames: boolean;
  /** Steps of a fixed length, in which a push may be that of a place some px before or after (`fast`, `standard`). */
  readonly steps: boolean;
  /** Longest run, s; null: however long. */
  readonly seconds: number | null;
  /** The farthest jump from one look to the next, px; 0 in continuous time. */
  readonly jump: number;
  /** How far recoil can carry an asteroid while a run lasts, px. */
  drift(asteroid: number): number;
  /** A thing of the level with its place relative to the start. */
  place<T extends { readonly x: number; readonly y: number }>(thing: T): T;
}

/** How an accuracy plays, as far as proofs tell it apart: by frames, in continuous time by fixed steps, or with an error that is kept below any margin of theirs. */
export type Play = 'frames' | 'steps' | 'exact';

/** The claim of a proof about a level, for one way of playing. */
export function claimOf(level: Level, about: About, maxTime: number | null, play: Play): Claim {
  const frames = play === 'frames';
  const { astronaut, range } = level;
  const rules = rulesOf(level);
  const box = boxOf(rules);
  const place = <T extends { readonly x: number; readonly y: number }>(thing: T): T => ({
    ...thing,
    x: thing.x - astronaut.x,
    y: thing.y - astronaut.y,
  });
  const thing = place(about.kind === 'blackHole' ? level.blackHole : level.minerals[about.index]);
  const time = maxTime ?? DEFAULT_MAX_TIME;
  // frames go as far as in a frame more, and the last may end after it
  const square = frames ? (time + TICK) * (time + 2 * TICK) : time * time;
  const drift = (i: number): number => driftIn(level, rules, i, square);
  const push = mostPush(level, rules);
  return {
    level,
    rules,
    box,
    inner: Math.min(box.halfWidth, box.halfHeight),
    about,
    thing,
    touch: thing.radius + box.halfDiagonal,
    push,
    frames,
    steps: play === 'steps',
    seconds: maxTime,
    jump: frames ? frameJump() : 0,
    drift,
    place,
  };

  /**
   * Nothing accelerates her by more than `push`. If she has the speed v at a place, then some time ago she was at least
   * (v2 - v0^2) / (2 push) away from it, with v0 her speed at the start; and places in range are not farther from
   * each other than the diagonal of the box about all discs of the range (and a frame's flight beyond, at each end). Through wormholes she may fall
   * the same way again and again, up to the speed limit.
   */
  function frameJump(): number {
    const lows = level.asteroids.map((a, i) => ({ x: place(a).x - range - drift(i), y: place(a).y - range - drift(i) }));
    const highs = level.asteroids.map((a, i) => ({ x: place(a).x + range + drift(i), y: place(a).y + range + drift(i) }));
    const spread = (axis: 'x' | 'y') =>
      highs.reduce((most, p) => Math.max(most, p[axis]), 0) - lows.reduce((least, p) => Math.min(least, p[axis]), 0);
    const longest = longestFrame(rules);
    if (level.wormholes.length > 0) return longest;
    const width = spread('x') + 2 * longest;
    const height = spread('y') + 2 * longest;
    const way = Math.sqrt(width * width + height * height);
    const speed2 = astronaut.vx * astronaut.vx + astronaut.vy * astronaut.vy + 2 * push * way;
    return Math.min(longest, 1.001 * Math.sqrt(speed2) * TICK);
  }
}

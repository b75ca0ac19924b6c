import { type Box, boxOf, DEFAULT_MAX_TIME, TICK } from '../../engine/index.ts';
import { type Disc, type Level, type Place, type Rules, rulesOf } from '../../schema/basics/index.ts';
import type { About, Blocker } from '../prove/index.ts';
import { driftIn, longestFrame, mostPush, stepBlur } from './assumptions.ts';
import { isIndex } from './geometry.ts';

/**
 * What a certificate is checked against: places relative to the start (which is 0, 0), and the numbers on which the arguments
 * rest.
 */
export interface Claim {
  readonly level: Level;
  /** The rules of the level. */
  readonly rules: Rules;
  readonly box: Box;
  /** Her box contains a circle of this radius around its centre, px. */
  readonly inner: number;
  readonly about: About;
  /** The object that is claimed to be out of reach. */
  readonly thing: { readonly x: number; readonly y: number; readonly radius: number };
  /** Whenever her box touches the object, her centre is closer to its centre than this, px. */
  readonly touch: number;
  /** The greatest possible acceleration, px/s². */
  readonly push: number;
  /**
   * Whether she is observed only once per frame (`arcade`), so that she may jump between two observations. Otherwise her path
   * is continuous and every contact on it is found.
   */
  readonly frames: boolean;
  /** Whether steps have a fixed length, so that a push may be that of a place some px away (`fast`, `standard`). */
  readonly steps: boolean;
  /** What fixed steps may add to what acts on her in any direction, px/s²; 0 in frames and where errors do not count. */
  readonly blur: number;
  /** Length of the longest run, s; null for any length. */
  readonly seconds: number | null;
  /** The longest jump between two observations, px; 0 in continuous time. */
  readonly jump: number;
  /** How far recoil can carry an asteroid during a run, px. */
  drift(asteroid: number): number;
  /** An object of the level with its place relative to the start. */
  place<T extends { readonly x: number; readonly y: number }>(thing: T): T;
}

/**
 * How an accuracy simulates, as far as proofs distinguish it: in frames, in continuous time with fixed steps, or with an error
 * below every margin of a proof.
 */
export type Play = 'frames' | 'steps' | 'exact';

/** Creates the claim of a proof about a level, for one way of simulating. */
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
  // Frames go as far as one frame more of continuous time, and the last frame may end after it.
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
    blur: play === 'steps' ? stepBlur(level, rules) : 0,
    seconds: maxTime,
    jump: frames ? frameJump() : 0,
    drift,
    place,
  };

  /**
   * Lemma `jump`, by an energy bound. If her speed is v at some place, she was once at least (v² - v0²) / (2 push) away from
   * it, where v0 is her speed at the start. Places in range are no farther apart than the diagonal of the rectangle around all
   * discs of the range, plus one frame's flight at each end. With wormholes she may fall the same distance again and again, so
   * only the speed limit bounds v.
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

/**
 * The circle that a hazard covers at all times, wherever recoil moves it, px from the start; null when the object is no such
 * hazard.
 */
export function standingHazard({ level, about, place, drift }: Claim, by: Blocker | undefined): Disc | null {
  if (by?.kind === 'nova' && isIndex(by.index, level.novae)) return place(level.novae[by.index]);
  if (by?.kind === 'asteroid' && isIndex(by.index, level.asteroids) && level.asteroids[by.index].hot) {
    const { x, y, radius } = place(level.asteroids[by.index]);
    return { x, y, radius: radius - drift(by.index) };
  }
  // Touching the black hole ends the run, so on the way to a mineral it blocks like a hazard.
  return by?.kind === 'blackHole' && about.kind === 'mineral' ? place(level.blackHole) : null;
}

/** A mouth of a wormhole: a disc from which her centre is moved to another disc. Its centre is px from the start. */
interface Mouth extends Place {
  readonly radius: number;
  /** Centre of the other mouth. She comes out at the same place relative to it. */
  readonly exit: Place;
}

/** The mouths of the level: the near end of wormhole i is number 2 i, its far end 2 i + 1 (lemma `mouths`). */
export function mouthsOf({
  level,
  place,
}: Pick<Claim, 'place'> & { readonly level: Pick<Level, 'wormholes'> }): readonly Mouth[] {
  return level.wormholes.flatMap(({ x, y, toX, toY, radius }) => {
    const near = place({ x, y });
    const far = place({ x: toX, y: toY });
    return [
      { ...near, radius, exit: far },
      { ...far, radius, exit: near },
    ];
  });
}

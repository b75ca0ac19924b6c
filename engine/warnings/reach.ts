import Flatbush from 'flatbush';
import { type Asteroid, type Disc, type Level, objectName, type Place, type Rules } from '../../schema/basics/index.ts';
import { TICK } from '../constants.ts';
import { boxOf } from '../contact.ts';
import { EFFECTS } from '../effects/index.ts';
import { distance, px } from './bodies.ts';

/** Where she can be at all: never farther than the range from an asteroid that she can reach. */
export interface Reach {
  /** The largest distance from an asteroid at which her box can touch a circle of this radius before she is lost, px. */
  limit(radius: number): number;
  /** The nearest asteroid that she can reach; null in a level without asteroids. */
  nearest(place: Place): { readonly distance: number; readonly index: number } | null;
  /** Whether some asteroids lie beyond a gap that she cannot cross. */
  readonly hasIslands: boolean;
}

/** What is said of both objects that nobody can touch. */
export const RULE_OF_REACH =
  'She is lost when she is farther than the range from the centre of every asteroid, and her collision box reaches at most 18.9 px beyond her centre. ' +
  'Only asteroids that she can reach count, going from the range of one into the range of the next. In a level with recoil the warning allows for how far asteroids can drift within the longest run.';

/** Why an object cannot be touched, and what to do; null if it can. */
export function outOfReach(level: Level, reach: Reach, what: string, disc: Disc): { message: string; hint: string } | null {
  const nearest = reach.nearest(disc);
  const limit = reach.limit(disc.radius);
  if (nearest === null || nearest.distance < limit) return null;
  const whom = reach.hasIslands ? 'the nearest asteroid she can reach' : 'the nearest asteroid';
  return {
    message:
      `${what} is out of reach: ${whom}, ${objectName('asteroid', nearest.index)}, is ${px(nearest.distance)} away, ` +
      `and beyond ${px(limit)} she is lost before she touches it (range ${px(level.range)})`,
    hint: `bring ${what} and an asteroid at least ${px(nearest.distance - limit)} nearer to each other (more gives the player room), or raise the range`,
  };
}

// for fewer asteroids than this, a plain loop finds the nearest before an index would be built
const INDEX_FROM = 64;

// after this many comparisons every asteroid counts as reachable: that may miss a warning but never gives a false one
const MAX_COMPARISONS = 1_000_000;

// `arcade` tests once a frame, so she can jump a gap that she crosses in one frame at the speed limit on both axes
const frameJump = ({ speedLimit }: Rules): number => speedLimit * TICK * Math.sqrt(2);

/**
 * Upper bound of how far recoil can carry an asteroid within the longest run, px: a t² / 2 with a = recoil / (2 radius). 0
 * without recoil.
 */
function drift(level: Level, { recoil }: Rules, maxTime: number): number {
  if (!level.recoil) return 0;
  const smallest = level.asteroids.reduce((r, a) => Math.min(r, a.radius), Number.POSITIVE_INFINITY);
  return (recoil * maxTime * maxTime) / (4 * smallest);
}

/**
 * Finds the asteroids that she can reach from the start, going from range to range. All of them count if she starts in no
 * range, or if an effect may put her anywhere.
 * @param maxTime - the longest a run may last, s: recoil moves asteroids for as long
 */
export function reachOf(level: Level, rules: Rules, maxTime: number): Reach {
  const slack = drift(level, rules, maxTime);
  const { halfDiagonal } = boxOf(rules);
  const jumps = EFFECTS.some((effect) => effect.jumps === true && effect.calledFor(level).called);
  const reached = jumps ? [...level.asteroids.keys()] : island(level, 2 * level.range + 2 * slack + frameJump(rules));
  let index: Flatbush | null = null;
  return {
    limit: (radius) => level.range + radius + halfDiagonal + slack,
    nearest(place) {
      if (reached.length >= INDEX_FROM) index ??= indexOf(level.asteroids, reached);
      const found =
        index === null ? nearestOf(level.asteroids, reached, place) : reached[index.neighbors(place.x, place.y, 1)[0]];
      return found === undefined ? null : { distance: distance(level.asteroids[found], place), index: found };
    },
    hasIslands: reached.length < level.asteroids.length,
  };
}

/** Indices of the asteroids that are linked to one in range at the start by steps of at most `step` px. */
function island(level: Level, step: number): readonly number[] {
  const { asteroids, astronaut, range } = level;
  const all = [...asteroids.keys()];
  const reached = all.filter((i) => distance(asteroids[i], astronaut) <= range);
  if (reached.length === 0 || reached.length === all.length) return all;
  let waiting = all.filter((i) => distance(asteroids[i], astronaut) > range);
  let comparisons = 0;
  for (let next = 0; next < reached.length && waiting.length > 0; next++) {
    comparisons += waiting.length;
    if (comparisons > MAX_COMPARISONS) return all;
    const from = asteroids[reached[next]];
    const left: number[] = [];
    for (const i of waiting) (distance(asteroids[i], from) <= step ? reached : left).push(i);
    waiting = left;
  }
  return reached;
}

function indexOf(asteroids: readonly Asteroid[], chosen: readonly number[]): Flatbush {
  const index = new Flatbush(chosen.length);
  for (const i of chosen) index.add(asteroids[i].x, asteroids[i].y);
  index.finish();
  return index;
}

function nearestOf(asteroids: readonly Asteroid[], chosen: readonly number[], place: Place): number | undefined {
  let best: number | undefined;
  let least = Number.POSITIVE_INFINITY;
  for (const i of chosen) {
    const d = distance(asteroids[i], place);
    if (d >= least) continue;
    best = i;
    least = d;
  }
  return best;
}

import Flatbush from 'flatbush';
import type { Asteroid, Level, Rules } from '../../schema/index.ts';
import { DEFAULT_MAX_TIME, TICK } from '../constants.ts';
import { boxOf } from '../contact/index.ts';
import { EFFECTS } from '../effects/index.ts';
import { distance, type Place } from './geometry.ts';

/** Where she can be at all: never farther than the range from an asteroid she can come to. */
export interface Reach {
  /** How far from an asteroid her box can touch a circle of this radius and not be lost, px. */
  limit(radius: number): number;
  /** The nearest asteroid she can come to, or null in a level without asteroids. */
  nearest(place: Place): { readonly distance: number; readonly index: number } | null;
  /** Whether some asteroids lie beyond a gap that she can't cross. */
  readonly hasIslands: boolean;
}

// below this many asteroids a plain loop finds the nearest sooner than an index is built
const INDEX_FROM = 64;

// more comparisons than this and every asteroid counts as one she can come to: too kind, never wrong
const MAX_COMPARISONS = 1_000_000;

// `arcade` looks once a frame, so it lets her jump a gap of one frame's flight at the speed limit on both axes
const frameJump = ({ speedLimit }: Rules): number => speedLimit * TICK * Math.sqrt(2);

/**
 * How far recoil can carry an asteroid within the longest default run, px: a t2 / 2 with a = recoil / (2 radius).
 * 0 without recoil.
 */
function drift(level: Level, { recoil }: Rules): number {
  if (!level.recoil) return 0;
  const smallest = level.asteroids.reduce((r, a) => Math.min(r, a.radius), Number.POSITIVE_INFINITY);
  return (recoil * DEFAULT_MAX_TIME * DEFAULT_MAX_TIME) / (4 * smallest);
}

/**
 * Finds the asteroids she can come to from the start, hopping from range to range; all of them if she starts in none, or if an
 * effect may put her anywhere.
 */
export function reachOf(level: Level, rules: Rules): Reach {
  const slack = drift(level, rules);
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

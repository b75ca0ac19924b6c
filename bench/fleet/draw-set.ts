import { addToLeast, MOST_ASSIGNED } from '../../cli/fleet/index.ts';
import type { LevelCosts } from './assumptions.ts';
import type { ShardCosts } from './simulate-fleet.ts';

/** A set of levels, by what they cost and by what the rule sees of their hashes. */
export interface DrawnSet {
  readonly costs: LevelCosts;
  /** For each level, the index of its cost. */
  readonly drawn: Uint16Array;
  /** The first 32 bits of its hash. */
  readonly hashes: Uint32Array;
}

/** How a plan splits a set: by the rule alone, or with the costs of the last time. */
export type Split = 'rule' | '--costs';

/**
 * Draws levels with the costs of measured ones.
 * @param costs the dearest first
 * @param random numbers in [0, 1)
 */
export function drawSet(levels: number, costs: LevelCosts, random: () => number): DrawnSet {
  if (costs.length === 0 || costs.length > 65_536) throw new RangeError(`expected 1 to 65536 costs, found ${costs.length}`);
  const drawn = new Uint16Array(levels);
  const hashes = new Uint32Array(levels);
  for (let i = 0; i < levels; i++) {
    drawn[i] = Math.floor(random() * costs.length);
    hashes[i] = Math.floor(random() * 2 ** 32);
  }
  return { costs, drawn, hashes };
}

/** What a process costs besides its levels, s. */
export interface ProcessCosts {
  readonly start: number;
  /** One level of another shard. */
  readonly scan: number;
}

/** What the shards of a plan cost, split as `gq plan` does it. */
export function splitSet(set: DrawnSet, shards: number, split: Split, { start, scan }: ProcessCosts): ShardCosts {
  const { costs, drawn, hashes } = set;
  const useful = new Float64Array(shards);
  const own = new Uint32Array(shards);
  const dearest = split === 'rule' ? [] : dearestLevels(set, MOST_ASSIGNED);
  const isAssigned = new Uint8Array(drawn.length);
  for (const level of dearest) isAssigned[level] = 1;
  for (let level = 0; level < drawn.length; level++) {
    if (isAssigned[level] === 1) continue;
    const shard = hashes[level] % shards;
    useful[shard] += costs[drawn[level]];
    own[shard]++;
  }
  const takers = addToLeast(
    dearest.map((level) => costs[drawn[level]]),
    useful,
  );
  for (const shard of takers) own[shard]++;
  const overhead = Float64Array.from(own, (count) => start + scan * (drawn.length - count));
  return { useful, overhead };
}

/** The levels that cost most, the dearest first. */
function dearestLevels({ costs, drawn }: DrawnSet, most: number): number[] {
  // where the levels of each cost begin
  const places = new Uint32Array(costs.length + 1);
  for (const cost of drawn) places[cost + 1]++;
  for (let cost = 1; cost <= costs.length; cost++) places[cost] += places[cost - 1];
  const dearest: number[] = new Array(Math.min(most, drawn.length)).fill(0);
  // not entries(): of ten million, they take seconds
  for (let level = 0; level < drawn.length; level++) {
    const place = places[drawn[level]]++;
    if (place < dearest.length) dearest[place] = level;
  }
  return dearest;
}

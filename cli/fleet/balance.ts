import FlatQueue from 'flatqueue';
import { contentHash } from './digest.ts';
import { keyOfHash, shardByHash } from './rule.ts';

/** What levels have cost, ms by name. */
export type Costs = ReadonlyMap<string, number>;

/** Levels that a plan assigns at most; the rule spreads the others, which cost less. */
export const MOST_ASSIGNED = 65_536;

/** How levels are spread by what they have cost. */
export interface Balanced {
  /** For each shard, the first 48 bits in base 16 of the hashes of the levels that it gets whatever the rule says. */
  readonly assigned: readonly (readonly string[])[];
  /** ms that each shard is expected to take in one thread */
  readonly expected: readonly number[];
  /** Levels with a known cost. */
  readonly known: number;
}

/**
 * Spreads levels over shards, the longest first, each to the shard that has least so far (Graham's LPT rule: at most 4/3 of the
 * best). A level whose cost is not known counts as the mean of the others.
 */
export async function balance(
  entries: AsyncIterable<{ readonly name: string; readonly content: Uint8Array }>,
  costs: Costs,
  shards: number,
): Promise<Balanced> {
  const mean = costs.size === 0 ? 1 : [...costs.values()].reduce((sum, ms) => sum + ms, 0) / costs.size;
  // levels of the same bytes go to the same shard
  const byKey = new Map<number, number>();
  const ruled = new Map<number, number>();
  let known = 0;
  for await (const { name, content } of entries) {
    const hash = contentHash(content);
    const cost = costs.get(name);
    if (cost !== undefined) known++;
    const key = keyOfHash(hash);
    byKey.set(key, (byKey.get(key) ?? 0) + (cost ?? mean));
    ruled.set(key, shardByHash(hash, shards));
  }
  const longestFirst = [...byKey].sort(([a, x], [b, y]) => y - x || a - b);
  const loads = new Float64Array(shards);
  for (const [key, ms] of longestFirst.slice(MOST_ASSIGNED)) loads[ruled.get(key)!] += ms;
  const longest = longestFirst.slice(0, MOST_ASSIGNED);
  const takers = addToLeast(
    longest.map(([, ms]) => ms),
    loads,
  );
  const assigned: string[][] = Array.from({ length: shards }, () => []);
  // the rule may be right already, but a plan without exceptions is no shorter to explain
  for (const [i, [key]] of longest.entries()) assigned[takers[i]].push(key.toString(16).padStart(12, '0'));
  return { assigned: assigned.map((keys) => keys.sort()), expected: [...loads], known };
}

/**
 * Adds costs to loads in their order, each to the load that is least at that time.
 * @param loads are changed
 * @returns for each cost, the index of its load
 */
export function addToLeast(costs: readonly number[], loads: Float64Array): number[] {
  const least = new FlatQueue<number>();
  for (const [i, load] of loads.entries()) least.push(i, load);
  return costs.map((cost) => {
    const i = least.pop()!;
    loads[i] += cost;
    least.push(i, loads[i]);
    return i;
  });
}

import FlatQueue from 'flatqueue';
import { contentHash, keyOfHash, shardByKey } from './digest.ts';

/** Numbers by whole numbers from 0 to 2^48: 32 bytes for each at most, where a Map takes three times as much. */
export class NumberTable {
  private keys = new Float64Array(1024).fill(-1);
  private values = new Float64Array(1024);
  private count = 0;

  get size(): number {
    return this.count;
  }

  get(key: number): number | undefined {
    const at = this.placeOf(key);
    return this.keys[at] === key ? this.values[at] : undefined;
  }

  set(key: number, value: number): void {
    const at = this.placeOf(key);
    this.values[at] = value;
    if (this.keys[at] === key) return;
    this.keys[at] = key;
    this.count++;
    if (2 * this.count > this.keys.length) this.grow();
  }

  *entries(): Generator<readonly [key: number, value: number]> {
    for (const [at, key] of this.keys.entries()) if (key >= 0) yield [key, this.values[at]];
  }

  /** Where a key is, or may be put. The keys are parts of hashes, so they are spread already. */
  private placeOf(key: number): number {
    const { keys } = this;
    let at = key % keys.length;
    while (keys[at] >= 0 && keys[at] !== key) at = (at + 1) % keys.length;
    return at;
  }

  private grow(): void {
    const { keys, values } = this;
    this.keys = new Float64Array(2 * keys.length).fill(-1);
    this.values = new Float64Array(2 * keys.length);
    for (const [i, key] of keys.entries()) {
      if (key < 0) continue;
      const at = this.placeOf(key);
      this.keys[at] = key;
      this.values[at] = values[i];
    }
  }
}

/** What levels have cost, ms by name. Names are known by their hashes alone, as there may be millions. */
export class Costs {
  private readonly byName = new NumberTable();
  private total = 0;

  set(name: string, ms: number): void {
    const key = keyOfName(name);
    this.total += ms - (this.byName.get(key) ?? 0);
    this.byName.set(key, ms);
  }

  get = (name: string): number | undefined => this.byName.get(keyOfName(name));

  /** Of all levels, ms; 1 if there are none. */
  get mean(): number {
    return this.byName.size === 0 ? 1 : this.total / this.byName.size;
  }

  get areAllZero(): boolean {
    return this.total === 0;
  }
}

const keyOfName = (name: string): number => keyOfHash(contentHash(Buffer.from(name)));

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
  const { mean } = costs;
  // levels of the same bytes go to the same shard
  const byKey = new NumberTable();
  let known = 0;
  for await (const { name, content } of entries) {
    const cost = costs.get(name);
    if (cost !== undefined) known++;
    const key = keyOfHash(contentHash(content));
    byKey.set(key, (byKey.get(key) ?? 0) + (cost ?? mean));
  }
  const least = leastAssigned(byKey);
  const loads = new Float64Array(shards);
  const longest: Entry[] = [];
  for (const entry of byKey.entries()) {
    if (compare(entry, least) <= 0) longest.push(entry);
    else loads[shardByKey(entry[0], shards)] += entry[1];
  }
  longest.sort(compare);
  const takers = addToLeast(
    longest.map(([, ms]) => ms),
    loads,
  );
  const assigned: string[][] = Array.from({ length: shards }, () => []);
  // the rule may be right already, but a plan without exceptions is no shorter to explain
  for (const [i, [key]] of longest.entries()) assigned[takers[i]].push(key.toString(16).padStart(12, '0'));
  return { assigned: assigned.map((keys) => keys.sort()), expected: [...loads], known };
}

type Entry = readonly [key: number, ms: number];

/** The longest first. */
const compare = ([a, x]: Entry, [b, y]: Entry): number => y - x || a - b;

/** The last of the entries that a plan assigns. */
function leastAssigned(byKey: NumberTable): Entry {
  const costs = new Float64Array(byKey.size);
  let at = 0;
  for (const [, ms] of byKey.entries()) costs[at++] = ms;
  costs.sort();
  const ms = costs[Math.max(0, costs.length - MOST_ASSIGNED)] ?? 0;
  // of those that cost the same, the first by their keys
  const longer = costs.reduce((count, cost) => count + (cost > ms ? 1 : 0), 0);
  const keys = Float64Array.from(
    (function* () {
      for (const [key, cost] of byKey.entries()) if (cost === ms) yield key;
    })(),
  ).sort();
  return [keys[Math.min(keys.length, MOST_ASSIGNED - longer) - 1] ?? 0, ms];
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

/** Bytes of a key. */
const KEY = 6;

/** The key of an entry: the first 48 bits of the hash of its bytes. */
export const keyOfHash = (hash: Buffer): number => hash.readUIntBE(0, KEY);

/** The shard of an entry, unless a plan assigns another: the first 32 bits of the hash of its bytes, modulo the number of shards. */
export const shardByKey = (key: number, shards: number): number => Math.floor(key / 2 ** 16) % shards;

/** Shards of entries by the first 48 bits of the hashes of their bytes, as threads share them. */
export interface Assigned {
  /** Sorted. */
  readonly keys: Float64Array;
  readonly shards: Uint16Array;
}

/** How a set is split. */
export interface Rule {
  readonly shards: number;
  readonly assigned: Assigned;
}

/** Entries that a plan assigns: for each shard, the first 48 bits of hashes in base 16. */
export function assignedOf(texts: readonly (readonly string[])[]): Assigned {
  const pairs = texts.flatMap((keys, shard) => keys.map((key) => ({ key: Number.parseInt(key, 16), shard })));
  pairs.sort((a, b) => a.key - b.key);
  const keys = new Float64Array(new SharedArrayBuffer(8 * pairs.length));
  const shards = new Uint16Array(new SharedArrayBuffer(2 * pairs.length));
  for (const [i, pair] of pairs.entries()) {
    keys[i] = pair.key;
    shards[i] = pair.shard;
  }
  return { keys, shards };
}

/** The shard of an entry. @param hash of its bytes */
export function shardOf(hash: Buffer, { shards, assigned }: Rule): number {
  const { keys } = assigned;
  const key = keyOfHash(hash);
  let low = 0;
  let high = keys.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (keys[middle] < key) low = middle + 1;
    else high = middle;
  }
  return keys[low] === key ? assigned.shards[low] : shardByKey(key, shards);
}

import { createHash, hash } from 'node:crypto';

/** Bytes of a SHA-256. */
export const DIGEST = 32;

/** The hash of an entry's bytes: decides its shard. */
export const contentHash = (content: Uint8Array): Buffer => hash('sha256', content, 'buffer');

// at once: a Hash object for each takes longer than the hash, and outlives collections of garbage
const sha256 = (...parts: readonly Uint8Array[]): Buffer => contentHash(Buffer.concat(parts));

/** The hash of an entry: of its bytes, by their hash, and of its name. */
export const entryHash = (content: Uint8Array, name: string): Buffer => sha256(content, Buffer.from(name));

/** Blocks of a set at most. */
const MOST_BLOCKS = 4096;

/**
 * The hashes of a set in blocks of consecutive entries, so that a difference has a place. The number of entries in a block is a
 * power of two, and the hash of a block that of its two halves, so a set of unknown size needs little memory: whenever there are
 * too many blocks, two become one.
 */
export class SetDigest {
  private blocks: Buffer[] = [];
  /** The hashes of the block under way, of 1, 2, 4, ... entries; each entry of a binary counter. */
  private readonly partial: (Buffer | null)[] = [];
  private count = 0;

  /**
   * @param size entries in a block; grows unless `onBlock` is given
   * @param onBlock gets each block that is complete, in place of keeping it
   */
  constructor(
    private size = 1,
    private readonly onBlock: ((hash: Buffer, index: number) => void) | null = null,
  ) {}

  /** The number of entries. */
  get entries(): number {
    return this.count;
  }

  add(hash: Buffer): void {
    let node = hash;
    let level = 0;
    for (let half = 1; half < this.size; half *= 2, level++) {
      const left = this.partial[level] ?? null;
      if (left === null) {
        this.partial[level] = node;
        this.count++;
        return;
      }
      this.partial[level] = null;
      node = sha256(left, node);
    }
    this.count++;
    this.endBlock(node);
  }

  /** Ends the last block. @returns all blocks, and how many entries each of them has */
  end(): { readonly size: number; readonly blocks: readonly string[] } {
    let last: Buffer | null = null;
    for (const node of this.partial) if (node !== null && node !== undefined) last = last === null ? node : sha256(node, last);
    this.partial.length = 0;
    if (last !== null) this.endBlock(last);
    return { size: this.size, blocks: this.blocks.map((hash) => hash.toString('hex', 0, 16)) };
  }

  private endBlock(node: Buffer): void {
    if (this.onBlock !== null) {
      this.onBlock(node, Math.ceil(this.count / this.size) - 1);
      return;
    }
    this.blocks.push(node);
    if (this.blocks.length < MOST_BLOCKS || this.count % this.size !== 0) return;
    const { blocks } = this;
    this.blocks = [];
    for (let i = 0; i < blocks.length; i += 2) this.blocks.push(sha256(blocks[i], blocks[i + 1]));
    this.size *= 2;
  }
}

/** The hash of a shard: of its entries and of their numbers within the set. */
export class ShardDigest {
  private readonly hash = createHash('sha256');
  private count = 0;
  private readonly number = Buffer.alloc(8);

  get entries(): number {
    return this.count;
  }

  add(n: number, hash: Uint8Array): void {
    this.number.writeDoubleLE(n);
    this.hash.update(this.number).update(hash);
    this.count++;
  }

  end(): string {
    return this.hash.digest('hex');
  }
}

/** Bytes of a key. */
const KEY = 6;

/** The key of an entry: the first 48 bits of the hash of its bytes. */
export const keyOfHash = (hash: Buffer): number => hash.readUIntBE(0, KEY);

/** The shard of an entry, unless a plan assigns another: the first 32 bits of the hash of its bytes, modulo the number of shards. */
export const shardByKey = (key: number, shards: number): number => Math.floor(key / 2 ** 16) % shards;

/** Shards of entries by the first 48 bits of the hashes of their bytes, as threads share them. */
interface Assigned {
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

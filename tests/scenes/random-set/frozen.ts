import { createHash } from 'node:crypto';
import { formatLevel } from '../../../schema/index.ts';
import { RANDOM_SET_SIZE, randomLevel } from './random-level.ts';

/**
 * SHA-256 of the whole set: the canonical text of every level, in the order of the seeds. Figures can be compared only on the
 * same set.
 */
export const RANDOM_SET_HASH = '417f1576bd6189c51b14961471c34adb8136604efb69669e9d51721ad467f91c';

/** The hash of the set as this machine makes it. */
export function hashRandomSet(): string {
  const hash = createHash('sha256');
  for (let seed = 0; seed < RANDOM_SET_SIZE; seed++) hash.update(formatLevel(randomLevel(seed)));
  return hash.digest('hex');
}

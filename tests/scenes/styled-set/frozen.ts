import { createHash } from 'node:crypto';
import { formatLevel } from '../../../schema/index.ts';
import { STYLED_SET_SIZE, styledLevel } from './styled-level.ts';

/** SHA-256 of the whole set: the canonical text of every level, in the order of the seeds. */
export const STYLED_SET_HASH = 'cd51f8df0ba3864ccccd4a66479f159792d73b368c90359b70c9237b4e73bd7c';

/** The hash of the set as this machine makes it. */
export function hashStyledSet(): string {
  const hash = createHash('sha256');
  for (let seed = 0; seed < STYLED_SET_SIZE; seed++) hash.update(formatLevel(styledLevel(seed)));
  return hash.digest('hex');
}

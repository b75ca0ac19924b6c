import { levelHash } from '../../game/index.ts';
import type { Level } from '../../schema/index.ts';
import type { OpenLevel } from '../context/index.ts';

const hashes = new WeakMap<Level, string>();

/** The hash of the open level as it is now. */
export function hashNow({ proof }: Pick<OpenLevel, 'proof'>): string {
  const { level } = proof.proof();
  const hash = hashes.get(level) ?? levelHash(level);
  hashes.set(level, hash);
  return hash;
}

import { type CheckedFile, checkTogether } from './check-level.ts';
import type { CheckSettings } from './checked-level.ts';

/** A message to a worker. */
export interface Batch {
  readonly files: readonly string[];
  readonly settings: CheckSettings;
  /** The key of the cache; null without one. */
  readonly cacheKey: string | null;
}

/** Runs in a worker thread: checks a batch of level files. */
export default function checkBatch({ files, settings, cacheKey }: Batch): CheckedFile[] {
  return checkTogether(
    files.map((file) => ({ file })),
    settings,
    cacheKey,
  );
}

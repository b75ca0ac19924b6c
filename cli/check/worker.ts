import { checkLevel } from './check-level.ts';
import type { CheckedLevel, CheckSettings } from './checked-level.ts';

/** A message to a worker. */
export interface Batch {
  readonly files: readonly string[];
  readonly settings: CheckSettings;
}

/** Runs in a worker thread: checks a batch of level files. */
export default function checkBatch({ files, settings }: Batch): CheckedLevel[] {
  return files.map((file) => checkLevel(file, settings));
}

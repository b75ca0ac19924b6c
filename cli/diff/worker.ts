import type { DiffedLevel, DiffTask } from './comparison.ts';
import { diffLevel } from './diff-level.ts';

/** Runs in a worker thread: compares the two versions of one level file. */
export default function diff(task: DiffTask): DiffedLevel {
  return diffLevel(task);
}

import { unusualTerms } from '../../engine/basics/index.ts';
import type { LockEntry } from '../../schema/index.ts';
import type { CheckedLevel } from '../check/index.ts';

/** The entry of a lock for a level that was checked with `forLock`. */
export function entryOf({ verdict, run, mineralCount, terms }: CheckedLevel): LockEntry {
  const { accuracy, rules } = terms;
  const { maxTime, maxWork } = unusualTerms(terms);
  return {
    verdict,
    accuracy,
    ...(maxTime !== undefined && { maxTime }),
    ...(maxWork !== undefined && { maxWork }),
    ...(run !== null && { outcome: run.outcome, tick: run.tick, minerals: mineralsOf(run), mineralCount }),
    ...(run?.certifiedTicks != null && { certifiedTicks: run.certifiedTicks }),
    ...(Object.keys(rules).length > 0 && { rules }),
    ...(run?.hash != null && { hash: run.hash }),
  };
}

// a frame of `arcade` can touch the same mineral twice
const mineralsOf = ({ minerals }: NonNullable<CheckedLevel['run']>): number => new Set(minerals.map(({ index }) => index)).size;

/** Whether the result of a level can be agreed on: a file that was not read, or on which gq failed, has none. */
export const hasResult = ({ unreadable, verdict }: CheckedLevel): boolean => !unreadable && verdict !== 'crashed';

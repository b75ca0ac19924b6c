import { plural } from '../../check/words/index.ts';
import type { Terms } from '../../engine/basics/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { Failure, shellPath } from '../io/index.ts';
import { compareLevels } from './compare-levels.ts';
import { goneInWords, goneUnder } from './gone.ts';
import { lockKey, type OpenedLock, openLock } from './lock-file.ts';
import { updateLock } from './update.ts';

/** The comparison of a check with a lock. */
export interface LockComparison {
  /** Adds to levels what differs from the lock; nothing when the lock is to be updated. */
  compare(levels: readonly CheckedLevel[]): readonly CheckedLevel[];
  /**
   * Ends the comparison: updates the lock if that was asked for.
   * @param isWhole whether all levels were checked that should be
   * @returns messages for people
   */
  end(levels: readonly CheckedLevel[], isWhole: boolean): Promise<string>;
}

/** What is compared with a lock. */
export interface Compared {
  /** The lock file. */
  readonly file: string;
  /** Whether to agree anew. */
  readonly update: boolean;
  /** Those of the check. */
  readonly terms: Terms;
  /** The paths that were given. */
  readonly paths: readonly string[];
  /** The level files that they name. */
  readonly levels: readonly string[];
}

/**
 * Opens a lock to compare a check with it.
 * @throws Failure if it can't be read, is not valid, or has results at another accuracy
 */
export function openComparison({ file, update, terms, paths, levels }: Compared): LockComparison {
  const opened = openLock(file, update);
  const isGone = goneUnder(paths);
  if (update) {
    return {
      compare: (checked) => checked,
      end: async (checked, isWhole) =>
        isWhole ? updateLock(checked, opened, isGone) : `${file}: not updated, because not every level was checked\n`,
    };
  }
  refuseOtherAccuracy(opened, levels, terms.accuracy.name);
  return {
    compare: (checked) => compareLevels(checked, opened),
    end: async () => goneInWords(opened, isGone),
  };
}

/** Results at different accuracies can't be compared: the motion differs in its last digits at least. */
function refuseOtherAccuracy({ file, lock }: OpenedLock, levels: readonly string[], accuracy: string): void {
  const others = levels.flatMap((level) => {
    const key = lockKey(file, level);
    const entry = Object.hasOwn(lock.levels, key) ? lock.levels[key] : undefined;
    return entry === undefined || entry.accuracy === accuracy ? [] : [{ key, accuracy: entry.accuracy }];
  });
  if (others.length === 0) return;
  const [{ key, accuracy: agreed }] = others;
  throw new Failure(
    `nothing was done: this check is at the accuracy ${accuracy}, but ${file} has results at ${agreed} (${key}${
      others.length > 1 ? `, and ${plural(others.length - 1, 'more level')}` : ''
    }), which can't be compared\ncheck at that accuracy, or agree anew: gq check ${shellPath(key)} --accuracy ${shellPath(accuracy)} --lock ${shellPath(file)} --update-lock`,
  );
}

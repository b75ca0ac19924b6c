import { readFileSync } from 'node:fs';
import { lockKey } from './lock-file.ts';

/**
 * Tells which level files have another entry in a lock than before, or no longer one, or a new one.
 * @param before the text that the lock had; null: there was none
 */
export function changedEntries(file: string, before: string | null): (levelFile: string) => boolean {
  const [old, now] = [entriesIn(before), entriesIn(textOrNull(file))];
  // nothing is known of a lock that is no lock; the comparison says what is wrong with it
  if (old === null || now === null) return () => true;
  return (levelFile) => {
    const key = lockKey(file, levelFile);
    return old.get(key) !== now.get(key);
  };
}

function textOrNull(file: string): string | null {
  try {
    return readFileSync(file, 'utf8');
  } catch {
    return null;
  }
}

/** The entries of a lock as texts, by their keys; null if it is not one. */
function entriesIn(text: string | null): Map<string, string> | null {
  if (text === null) return null;
  try {
    const { levels } = JSON.parse(text) as { levels: Record<string, unknown> };
    return new Map(Object.entries(levels).map(([key, entry]) => [key, JSON.stringify(entry)]));
  } catch {
    return null;
  }
}

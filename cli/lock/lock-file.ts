import { readFileSync } from 'node:fs';
import { dirname, isAbsolute, relative, resolve, sep } from 'node:path';
import process from 'node:process';
import { formatLock, LOCK_VERSION, type Lock, readLock } from '../../schema/index.ts';
import { readBytes, statOrError, writeWhole } from '../io/index.ts';
import { showFileProblems, showProblems } from '../report-parts/index.ts';
import { colorsFor, Failure, shellPath } from '../terminal/index.ts';

/** A lock file that was read. */
export interface OpenedLock {
  /** Its path as it was given. */
  readonly file: string;
  readonly lock: Lock;
  /** The line of a level's entry, from 1. */
  lineOf(key: string): number;
}

/** The path by which a lock names a level file: from the folder of the lock, with `/` on every system. */
export function lockKey(lockFile: string, levelFile: string): string {
  const path = relative(resolve(dirname(lockFile)), resolve(levelFile));
  // another drive of Windows has no path from here
  return isAbsolute(path) ? path : path.split(sep).join('/');
}

/** The level file that a lock names, as a path from the working directory. */
export const lockedFile = (lockFile: string, key: string): string => relative('', resolve(dirname(lockFile), key));

/**
 * Reads a lock file.
 * @param isNew whether a missing file is an empty lock
 * @throws Failure if it can't be read or is not valid, with every problem and its place
 */
export function openLock(file: string, isNew: boolean): OpenedLock {
  const stats = statOrError(file);
  if (stats instanceof Error && (stats as NodeJS.ErrnoException).code === 'ENOENT') {
    if (isNew) return { file, lock: { version: LOCK_VERSION, levels: {} }, lineOf: () => 1 };
    throw new Failure(
      `there is no lock file ${shellPath(file)}: expected the results that were agreed on; gq check --lock ${shellPath(file)} --update-lock writes it`,
    );
  }
  const read = readLock(readBytes(file));
  if (read.ok) return { file, ...read };
  const problems = showFileProblems(file, showProblems(read.problems, read.text), colorsFor(process.stderr));
  const hint = read.problems.some(({ code }) => code === 'merge-markers')
    ? `a merge has left both sides in it: take one (git checkout --ours -- ${shellPath(file)}), then agree anew with gq check --update-lock`
    : 'correct it, or delete it and agree anew with gq check --update-lock';
  throw new Failure(`nothing was done: the lock is not valid:\n${problems}${hint}`);
}

/** Writes a lock in its canonical layout; a lock that has it already stays untouched. @returns whether it was written */
export async function writeLock(file: string, lock: Lock): Promise<boolean> {
  const text = formatLock(lock);
  if (!(statOrError(file) instanceof Error) && Buffer.from(text).equals(readBytes(file))) return false;
  await writeWhole(file, text);
  return true;
}

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

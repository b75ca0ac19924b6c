import { MAX_FILE_SIZE } from '../../schema/basics/index.ts';
import { contentKey, keyOf, openStore, semantics } from '../cache/index.ts';
import { nameOfFile, readRegularFile } from '../io/index.ts';
import { shellPath } from '../terminal/index.ts';
import type { CheckedLevel, CheckSettings } from './checked-level.ts';

/** Changes when what is kept about a level changes its shape. */
const SHAPE = 1;

/** A report to keep. */
export interface KeptLevel {
  /** The key of the file's bytes and of everything else that the report depends on. */
  readonly key: string;
  readonly text: string;
}

/** The reports of earlier checks with the same settings. */
export interface LevelCache {
  /** The key of everything that a report depends on besides the bytes of the file. */
  readonly key: string;
  /** The reports that are known for files with the bytes that they have now. */
  recall(files: readonly string[]): ReadonlyMap<string, CheckedLevel>;
  keep(kept: KeptLevel): void;
  /** Writes what was kept, unless a signal ends the process before. */
  save(): Promise<void>;
}

/**
 * Opens the cache in a folder.
 * @param semanticsNow the fingerprint of the code that decides
 * @returns null if there is no such fingerprint
 */
export function openLevelCache(folder: string, settings: CheckSettings, semanticsNow = semanticsOrNull): LevelCache | null {
  const code = semanticsNow();
  if (code === null) return null;
  const key = keyOf({ shape: SHAPE, code, settings });
  const store = openStore(folder);
  return {
    key,
    recall(files) {
      const recalled = new Map<string, CheckedLevel>();
      if (store.isEmpty()) return recalled;
      for (const file of files) {
        const bytes = bytesOrNull(file);
        const level = bytes === null ? null : parsed(store.get(contentKey(key, bytes)));
        if (level !== null) recalled.set(file, atFile(level, file));
      }
      return recalled;
    },
    keep: (kept) => store.put(kept.key, kept.text),
    async save() {
      // the toolkit may have been built anew meanwhile, and then nobody knows which code has decided
      if (semanticsNow() === code) await store.save();
    },
  };
}

/** The report of a level for the cache. */
export const keptLevel = (key: string, bytes: Uint8Array, level: CheckedLevel): KeptLevel => ({
  key: contentKey(key, bytes),
  text: JSON.stringify({ ...level, file: '' }),
});

function semanticsOrNull(): string | null {
  try {
    return semantics();
  } catch {
    return null;
  }
}

function bytesOrNull(file: string): Uint8Array | null {
  try {
    return readRegularFile(file, MAX_FILE_SIZE);
  } catch {
    // the check says why
    return null;
  }
}

const parsed = (text: string | null): CheckedLevel | null => (text === null ? null : (JSON.parse(text) as CheckedLevel));

/** Stands for the path of a valid level in its problems, so that the report does not depend on where the file lies. */
export const ANYWHERE = '\0level\0';

/** Whether names in a valid level may contain `ANYWHERE`: JSON has no other way to write its first character. */
export const mayMention = (json: string): boolean => json.includes('\\u0000');

/** The report for a file whose content has a report with `ANYWHERE` in place of its path. */
export function atFile(level: CheckedLevel, file: string): CheckedLevel {
  // a file that is not a valid level has no other name than its own, and its problems no path
  if (level.verdict === 'invalid') return { ...level, file, name: nameOfFile(file) };
  if (level.problems.length === 0) return level.file === file ? level : { ...level, file };
  const path = shellPath(file);
  const here = (text: string): string => (text.includes(ANYWHERE) ? text.replaceAll(ANYWHERE, () => path) : text);
  return {
    ...level,
    file,
    problems: level.problems.map((problem) => ({ ...problem, message: here(problem.message), hint: here(problem.hint) })),
  };
}

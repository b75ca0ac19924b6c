import { resolve, sep } from 'node:path';
import { entryChange, isAgreed, resultChange } from '../../check/lock/index.ts';
import { plural } from '../../check/words/index.ts';
import { type Terms, unusualTerms } from '../../engine/basics/index.ts';
import type { LockEntry } from '../../schema/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { statOrError } from '../io/index.ts';
import type { ShownProblem } from '../report-parts/index.ts';
import { Failure, shellPath, visibleLine } from '../terminal/index.ts';
import { lockedFile, lockKey, type OpenedLock, openLock, writeLock } from './lock-file.ts';

export { changedEntries } from './lock-file.ts';

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

/**
 * Adds to each level what differs from its entry in a lock.
 * @param levels results of a check with `forLock`
 */
const compareLevels = (levels: readonly CheckedLevel[], opened: OpenedLock): CheckedLevel[] =>
  levels.map((level) => {
    const problem = hasResult(level) ? lockProblem(level, opened) : null;
    return problem === null ? level : { ...level, problems: [...level.problems, problem] };
  });

const WHOLE_FILE: NonNullable<NonNullable<CheckedLevel['run']>['place']> = { pointer: '', line: null, column: null, frame: null };

function lockProblem(level: CheckedLevel, { file, lock, lineOf }: OpenedLock): ShownProblem | null {
  const key = lockKey(file, level.file);
  const agree = `gq check ${shellPath(level.file)} --lock ${shellPath(file)} --update-lock`;
  if (!Object.hasOwn(lock.levels, key)) {
    const message = `nothing was agreed on for this level: ${file} has no entry ${JSON.stringify(key)}`;
    return { code: 'not-in-lock', severity: 'error', message, hint: `to agree on its result: ${agree}`, ...WHOLE_FILE };
  }
  const change = resultChange(entryOf(level), lock.levels[key]);
  if (change === null) return null;
  const { words, rules } = change;
  return {
    code: 'result-changed',
    severity: 'error',
    message: `${rules === '' ? '' : `the rules differ (${rules}): `}${words}; agreed on in ${file}:${lineOf(key)}`,
    hint:
      rules === ''
        ? `if this is wanted, agree anew: ${agree}`
        : `check that the rules of the level and of gq.config.json are the wanted ones; if so, agree anew: ${agree}`,
    ...(level.run?.place ?? WHOLE_FILE),
  };
}

/** The part of a path before its first special character, up to a whole folder. */
const fixedPart = (path: string): string => {
  const at = path.search(/[*?]/);
  if (at < 0 || !(statOrError(path) instanceof Error)) return path;
  return path.slice(0, path.split(sep).join('/').lastIndexOf('/', at) + 1) || '.';
};

/**
 * Whether a level file is gone that paths would have found: nothing is there, and its place is one of the paths or below one.
 * Of a pattern, the folder before the first `*` or `?` counts.
 */
export function goneUnder(paths: readonly string[]): (levelFile: string) => boolean {
  const roots = paths.map((path) => resolve(fixedPart(path)));
  return (levelFile) => {
    const full = resolve(levelFile);
    const isUnder = roots.some((root) => full === root || full.startsWith(root.endsWith(sep) ? root : root + sep));
    if (!isUnder) return false;
    const stats = statOrError(levelFile);
    return stats instanceof Error && ['ENOENT', 'ENOTDIR'].includes((stats as NodeJS.ErrnoException).code ?? '');
  };
}

/** The entries of a lock whose level files are gone, in words for people; '' if there are none. */
function goneInWords({ file, lock, lineOf }: OpenedLock, isGone: (levelFile: string) => boolean): string {
  return Object.keys(lock.levels)
    .filter((key) => isGone(lockedFile(file, key)))
    .map((key) => `warning: ${file}:${lineOf(key)}: the level ${key} is gone; gq check --update-lock removes its entry\n`)
    .join('');
}

/**
 * Agrees anew: writes the results of levels into a lock, and keeps the other entries.
 * @param isGone whether the level file of an entry existed under the checked paths and is gone
 * @returns what has changed, for people
 */
async function updateLock(
  levels: readonly CheckedLevel[],
  { file, lock }: OpenedLock,
  isGone: (levelFile: string) => boolean,
): Promise<string> {
  const before = new Map(Object.entries(lock.levels));
  const after = new Map<string, LockEntry>(before);
  const lines: string[] = [];
  const counts = { added: 0, changed: 0, unchanged: 0, removed: 0 };
  for (const level of levels) {
    const key = lockKey(file, level.file);
    const old = before.get(key);
    if (!hasResult(level)) {
      lines.push(`  kept ${key}: it could not be checked`);
      continue;
    }
    const entry = entryOf(level);
    after.set(key, entry);
    if (old === undefined) {
      counts.added++;
      lines.push(`  added ${key}: ${entryInWords(entry)}`);
    } else if (isAgreed(entry, old)) {
      counts.unchanged++;
    } else {
      counts.changed++;
      lines.push(`  changed ${key}: ${entryChange(entry, old)}`);
    }
  }
  const checked = new Set(levels.map((level) => lockKey(file, level.file)));
  for (const key of before.keys()) {
    if (checked.has(key) || !isGone(lockedFile(file, key))) continue;
    after.delete(key);
    counts.removed++;
    lines.push(`  removed ${key}: the level is gone`);
  }
  const isWritten = await writeLock(file, { ...lock, levels: Object.fromEntries(after) });
  const said = Object.entries(counts).flatMap(([what, count]) => (count > 0 ? [`${count} ${what}`] : []));
  const other = after.size - counts.added - counts.changed - counts.unchanged;
  if (other > 0) said.push(`${plural(other, 'other entry', 'other entries')} kept`);
  const head = `${file}: ${isWritten ? 'agreed anew' : 'nothing to write'}${said.length === 0 ? '' : `: ${said.join(', ')}`}`;
  return [head, ...lines].map((line) => `${visibleLine(line)}\n`).join('');
}

function entryInWords({ verdict, outcome, tick }: LockEntry): string {
  return outcome === undefined ? verdict : `${verdict}, ${outcome} at tick ${tick}`;
}

/** The entry of a lock for a level that was checked with `forLock`. */
function entryOf({ verdict, run, mineralCount, terms }: CheckedLevel): LockEntry {
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
const hasResult = ({ unreadable, verdict }: CheckedLevel): boolean => !unreadable && verdict !== 'crashed';

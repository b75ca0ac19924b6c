import { resultChange } from '../../check/lock/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { shellPath } from '../io/index.ts';
import type { ShownProblem } from '../shown-problem.ts';
import { entryOf, hasResult } from './entry.ts';
import { lockKey, type OpenedLock } from './lock-file.ts';

/**
 * Adds to each level what differs from its entry in a lock.
 * @param levels results of a check with `forLock`
 */
export const compareLevels = (levels: readonly CheckedLevel[], opened: OpenedLock): CheckedLevel[] =>
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

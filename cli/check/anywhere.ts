import { nameOfFile, shellPath } from '../io/index.ts';
import type { CheckedLevel } from './checked-level.ts';

/** Stands for the path of a valid level in its problems, so that the report does not depend on where the file lies. */
export const ANYWHERE = '\0level\0';

/** Whether names in a valid level may contain `ANYWHERE`: JSON has no other way to write its first character. */
export const mayMention = (json: string): boolean => json.includes('\\u0000');

/** The report for a file whose content has a report with `ANYWHERE` in place of its path. */
export function atFile(level: CheckedLevel, file: string): CheckedLevel {
  // a file that is not a valid level has no other name than its own, and its problems no path
  if (level.verdict === 'invalid') return { ...level, file, name: nameOfFile(file) };
  const path = shellPath(file);
  const here = (text: string): string => (text.includes(ANYWHERE) ? text.replaceAll(ANYWHERE, () => path) : text);
  return {
    ...level,
    file,
    problems: level.problems.map((problem) => ({ ...problem, message: here(problem.message), hint: here(problem.hint) })),
  };
}

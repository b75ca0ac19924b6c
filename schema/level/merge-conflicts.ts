import { MAX_PROBLEMS, type Problem, quote } from '../basics/index.ts';
import type { LevelDocument } from './read-level.ts';
import type { LevelFile } from './shape.ts';

/** Values in messages are cut to this length, in characters. */
const LONGEST = 60;

/** A value of a conflict, as short JSON: `{"x":50,"y":0}`. */
function short(value: unknown): string {
  if (value === undefined) return 'nothing';
  if (typeof value === 'string') return quote(value);
  const text = JSON.stringify(value);
  return text.length > LONGEST ? `${text.slice(0, LONGEST - 1)}…` : text;
}

/**
 * The problems of a level in which a merge left something undecided: one for each entry of `conflicts` in the file.
 *
 * @param file - the content of a valid level file
 * @param locate - finds places in its text; the problems have no places when left out
 * @returns the problems; none if the file has no conflicts
 */
export function conflictProblems({ conflicts = [] }: LevelFile, locate?: LevelDocument['locate']): Problem[] {
  const problems = conflicts.slice(0, MAX_PROBLEMS).map(({ what, ours, theirs }, i): Problem => {
    const pointer = `/conflicts/${i}`;
    return {
      code: 'merge-conflict',
      severity: 'error',
      message: `${quote(what)} is undecided after a merge: ours is ${short(ours)}, theirs ${short(theirs)}`,
      hint: 'Open it with gq edit and choose, or delete the entry when the value in place is right.',
      pointer,
      ...(locate?.(pointer) ?? { line: null, column: null }),
    };
  });
  const rest = conflicts.length - problems.length;
  if (rest > 0) {
    const hint = 'Open the level with gq edit: it shows all of them.';
    const message = `and ${rest} more conflicts`;
    problems.push({ code: 'more-problems', severity: 'error', message, hint, pointer: '', line: null, column: null });
  }
  return problems;
}

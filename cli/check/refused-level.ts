import { termsReport } from '../../check/words/index.ts';
import type { Terms } from '../../engine/basics/index.ts';
import { nameOfFile } from '../io/index.ts';
import type { ShownProblem } from '../shown-problem.ts';
import type { CheckedLevel } from './checked-level.ts';

/** The report for a file that can't be read. */
export function unreadableLevel(file: string, message: string, terms: Terms): CheckedLevel {
  const hint = 'this level was not checked: make the file readable, or leave it out';
  return { ...refusedLevel(file, 'invalid', [problemOfFile('unreadable-file', message, hint)], terms), unreadable: true };
}

/** The report for a level that makes the toolkit itself fail. */
export function crashedLevel(file: string, error: unknown, terms: Terms): CheckedLevel {
  const message = `checking this level crashed: ${error instanceof Error ? error.message : String(error)}`;
  const problem = problemOfFile('crashed', message, 'this is a bug in gq: please report it, with the level file');
  return refusedLevel(file, 'crashed', [problem], terms);
}

const problemOfFile = (code: string, message: string, hint: string): ShownProblem => ({
  code,
  severity: 'error',
  message,
  hint,
  pointer: '',
  line: null,
  column: null,
  frame: null,
});

/** The report for a file of which only the problems are known. */
export function refusedLevel(
  file: string,
  verdict: 'invalid' | 'crashed',
  problems: readonly ShownProblem[],
  terms: Terms,
): CheckedLevel {
  return {
    file,
    name: nameOfFile(file),
    terms: termsReport({ terms, level: terms }),
    verdict,
    run: null,
    found: null,
    report: null,
    mineralCount: 0,
    problems,
    unreadable: false,
    ms: 0,
  };
}

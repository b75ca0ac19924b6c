import { nameOfFile } from '../name-of-file.ts';
import type { ShownProblem } from '../shown-problem.ts';
import type { CheckedLevel } from './checked-level.ts';

/** The report for a file that can't be read. */
export function unreadableLevel(file: string, message: string): CheckedLevel {
  const hint = 'this level was not checked: make the file readable, or leave it out';
  return { ...refusedLevel(file, 'invalid', [problemOfFile('unreadable-file', message, hint)]), unreadable: true };
}

/** The report for a level that makes the toolkit itself fail. */
export function crashedLevel(file: string, error: unknown): CheckedLevel {
  const message = `checking this level crashed: ${error instanceof Error ? error.message : String(error)}`;
  return refusedLevel(file, 'crashed', [
    problemOfFile('crashed', message, 'this is a bug in gq: please report it, with the level file'),
  ]);
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
export function refusedLevel(file: string, verdict: 'invalid' | 'crashed', problems: readonly ShownProblem[]): CheckedLevel {
  return {
    file,
    name: nameOfFile(file),
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

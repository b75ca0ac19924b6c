import { codeFrame, type Problem } from '../schema/index.ts';
import { MAX_SHOWN, type ShownProblem } from './shown-problem.ts';

/** Adds the lines of the file around it to each of the problems that will be shown and have a place in it. */
export function showProblems(problems: readonly Problem[], text: string): ShownProblem[] {
  return problems.map((problem, i) => ({
    ...problem,
    frame: i < MAX_SHOWN && problem.line !== null ? codeFrame(text, problem.line, problem.column ?? 1) : null,
  }));
}

import { codeFrame, type Problem } from '../schema/index.ts';
import { MAX_SHOWN, type ShownProblem } from './report-parts/index.ts';

/** Adds the surrounding lines of the file to each problem that will be shown and has a place in the file. */
export function showProblems(problems: readonly Problem[], text: string): ShownProblem[] {
  return problems.map((problem, i) => ({
    ...problem,
    frame: i < MAX_SHOWN && problem.line !== null ? codeFrame(text, problem.line, problem.column ?? 1) : null,
  }));
}

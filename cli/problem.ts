import { codeFrame, type Problem } from '../schema/index.ts';

/** A problem made ready to be shown: with the lines of the file around it. */
export interface ShownProblem extends Problem {
  readonly frame: string | null;
}

/** Beyond so many problems of one file the lines around them are not shown. */
export const MAX_FRAMES = 20;

/** Adds the lines of the file to the first problems that have a place in it. */
export function showProblems(problems: readonly Problem[], text: string): ShownProblem[] {
  return problems.map((problem, i) => ({
    ...problem,
    frame: i < MAX_FRAMES && problem.line !== null ? codeFrame(text, problem.line, problem.column ?? 1) : null,
  }));
}

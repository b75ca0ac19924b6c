import process from 'node:process';
import { colorsFor, Failure } from './io/index.ts';
import { showFileProblems } from './report-parts/index.ts';
import type { ShownProblem } from './shown-problem.ts';

/** The problems of a file that keep a command from its work. */
export interface FileProblems {
  readonly file: string;
  readonly problems: readonly ShownProblem[];
}

/**
 * Files have problems that must be corrected first. The message is for a terminal, with the lines around each place; who shows it
 * elsewhere takes `reason` and `files`.
 */
export class FileFailure extends Failure {
  /** @param reason what was not done and why, without the problems */
  constructor(
    readonly reason: string,
    readonly files: readonly FileProblems[],
  ) {
    const colors = colorsFor(process.stderr);
    super(
      `${reason}:\n${files
        .map(({ file, problems }) => showFileProblems(file, problems, colors))
        .join('')
        .trimEnd()}`,
    );
  }
}

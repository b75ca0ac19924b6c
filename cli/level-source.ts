import process from 'node:process';
import { findWarnings, type Run, type Terms } from '../engine/index.ts';
import { type Level, type LevelDocument, type Problem, readLevel } from '../schema/index.ts';
import { showProblems } from './code-frames.ts';
import type { CommandResult } from './command.ts';
import { colorsFor, Failure, isPackFile, NOT_A_LEVEL, notice, readBytes, visibleLine } from './io/index.ts';
import { showFileProblems } from './report-parts/index.ts';
import type { ShownProblem } from './shown-problem.ts';

export interface OpenedLevel {
  readonly level: Level;
  readonly document: LevelDocument;
}

/** A level with the bytes of its file, to notice later changes of the file. */
export interface OpenedFile extends OpenedLevel {
  readonly bytes: Uint8Array;
}

/**
 * Reads the level that a command works on.
 * @param terms the rules of the folder apply where the level has none of its own
 * @returns the level, or the result of the command if the file is not a valid level
 * @throws Failure if the file can't be read
 */
export function openLevel(file: string, { rules }: Pick<Terms, 'rules'>): OpenedFile | CommandResult {
  if (isPackFile(file)) throw new Failure(`${file}: ${NOT_A_LEVEL}`);
  const bytes = readBytes(file);
  const read = readLevel(bytes, { rules });
  if (read.ok) {
    const { length } = read.document.file.conflicts ?? [];
    if (length > 0) {
      const open = `${length === 1 ? 'a conflict' : `${length} conflicts`} of a merge`;
      notice(`warning: ${visibleLine(file)} has ${open}: gq used our values; gq check lists them, gq edit decides them\n`);
    }
    return { level: read.level, document: read.document, bytes };
  }
  return { messages: showFileProblems(file, showProblems(read.problems, read.text), colorsFor(process.stderr)), exitCode: 1 };
}

/** The warnings about a valid level and its simulated runs, with places. */
export function warningsOf({ level, document }: OpenedLevel, runs: readonly Run[], terms: Terms): ShownProblem[] {
  const warnings = findWarnings(level, runs, terms);
  return warnings.length === 0
    ? []
    : showProblems(
        warnings.map((w) => placed(w, document)),
        document.text,
      );
}

/** Adds the line and column of a problem's JSON pointer. */
export function placed(problem: Omit<Problem, 'line' | 'column'>, document: LevelDocument): Problem {
  if (problem.pointer === '') return { ...problem, line: null, column: null };
  return { ...problem, ...document.locate(problem.pointer) };
}

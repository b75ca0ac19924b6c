import process from 'node:process';
import { type OwnRules, readFolderRules } from '../schema/index.ts';
import { showProblems } from './code-frames.ts';
import { colorsFor } from './colors.ts';
import { findConfig } from './config-file.ts';
import { Failure } from './failure.ts';
import { readBytes } from './read-bytes.ts';
import { showFileProblems } from './report-parts/index.ts';

/**
 * The rules that the configuration of the working directory sets for its levels; none if there is no configuration.
 * @throws Failure if it can't be read or is invalid, with every problem and its place
 */
export function folderRules(): OwnRules {
  const file = findConfig();
  if (file === null) return {};
  const read = readFolderRules(readBytes(file));
  if (read.ok) return read.rules;
  const problems = showFileProblems(file, showProblems(read.problems, read.text), colorsFor(process.stderr));
  throw new Failure(`nothing was done: the configuration is not valid:\n${problems.trimEnd()}`);
}

import { spawnSync } from 'node:child_process';
import process from 'node:process';
import { Failure } from '../failure.ts';

/** A list of names may be long. */
const MOST_OUTPUT = 256 * 1024 * 1024;

/** The answer of git: its output, or its error. */
export interface GitAnswer {
  readonly ok: boolean;
  readonly output: string;
  /** What git says about a failure, on one line. */
  readonly error: string;
}

/**
 * Asks git in a folder.
 * @throws Failure if there is no git
 */
export function askGit(folder: string, args: readonly string[]): GitAnswer {
  const { status, stdout, stderr, error } = spawnSync('git', args, {
    cwd: folder,
    encoding: 'utf8',
    maxBuffer: MOST_OUTPUT,
    windowsHide: true,
    // in English, and without writing to the index
    env: { ...process.env, LC_ALL: 'C', GIT_OPTIONAL_LOCKS: '0' },
  });
  if (error !== undefined) {
    const isMissing = (error as NodeJS.ErrnoException).code === 'ENOENT';
    throw new Failure(
      isMissing
        ? '--changed asks git, and there is no command git: expected it in PATH; without it, name the levels to check'
        : `--changed: git can't be run: ${error.message}`,
    );
  }
  return {
    ok: status === 0,
    output: stdout,
    error: stderr
      .trim()
      .split('\n')[0]
      .replace(/^fatal: /, ''),
  };
}

import { spawnSync } from 'node:child_process';
import process from 'node:process';
import { Failure, systemReason } from '../failure.ts';

/**
 * Runs git in the working directory, with messages in English.
 * @returns what it prints, without the line end; null if it ends with another code than 0
 * @throws Failure if git can't be started
 */
export function runGit(args: readonly string[]): { readonly out: string | null; readonly error: string } {
  const { status, stdout, stderr, error } = spawnSync('git', args, { env: { ...process.env, LC_ALL: 'C' }, encoding: 'utf8' });
  if (error !== undefined) {
    const isMissing = (error as NodeJS.ErrnoException).code === 'ENOENT';
    throw new Failure(isMissing ? 'git was not found: install it first' : `git can't be started: ${systemReason(error)}`);
  }
  return { out: status === 0 ? stdout.replace(/\r?\n$/, '') : null, error: stderr.trim().replace(/^fatal: /, '') };
}

/** What git prints. @throws Failure with git's own words if it fails */
export function git(args: readonly string[]): string {
  const { out, error } = runGit(args);
  if (out === null) throw new Failure(`git ${args[0]} failed: ${error}`);
  return out;
}

/** The root of the working tree. @throws Failure outside of one */
export function workingTree(): string {
  const { out, error } = runGit(['rev-parse', '--is-inside-work-tree']);
  if (out === null && !/not a git repository/.test(error)) throw new Failure(`git can't be used here: ${error}`);
  if (out === null)
    throw new Failure('expected a git repository, found none in this folder or above it: go to one, or run git init first');
  if (out !== 'true')
    throw new Failure('expected a working tree, found a bare repository or its inside: run gq git-setup in a clone with files');
  return git(['rev-parse', '--show-toplevel']);
}

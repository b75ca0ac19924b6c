import { spawnSync } from 'node:child_process';
import process from 'node:process';
import { Failure, systemReason } from '../failure.ts';

/** The largest answer of git that is read, bytes. */
const MOST = 2 ** 30;

interface Answer {
  readonly status: number | null;
  readonly stdout: Buffer;
  readonly stderr: string;
}

/**
 * Runs git in the working directory. Its messages are in English and it takes no optional locks.
 * @throws Failure if git can't be started
 */
function ask(args: readonly string[], input?: string): Answer {
  const env = { ...process.env, LC_ALL: 'C', GIT_OPTIONAL_LOCKS: '0', GIT_PAGER: '' };
  const { status, stdout, stderr, error } = spawnSync('git', ['--no-pager', ...args], { input, env, maxBuffer: MOST });
  if ((error as NodeJS.ErrnoException | undefined)?.code === 'ENOENT') {
    throw new Failure('git was not found: install it, or give two files or two folders to compare');
  }
  if (error !== undefined) throw new Failure(`git ${args[0]} failed: ${systemReason(error)}`);
  return { status, stdout, stderr: stderr.toString().trim() };
}

/**
 * What git prints.
 * @throws Failure with git's own words if it fails
 */
export function git(args: readonly string[], input?: string): Buffer {
  const { status, stdout, stderr } = ask(args, input);
  if (status === 0) return stdout;
  throw new Failure(`git ${args[0]} failed: ${stderr.replace(/^fatal: /, '') || `it ended with ${status}`}`);
}

/** What git prints, without the line end; null if it fails. */
export function gitOrNull(args: readonly string[]): string | null {
  const { status, stdout } = ask(args);
  return status === 0 ? stdout.toString().trimEnd() : null;
}

/** Fields that end with NUL. */
export const splitNul = (bytes: Buffer): string[] => bytes.toString().split('\0').slice(0, -1);

/** The objects that names such as `HEAD:levels/a.level.json` or a hash stand for, in their order; null if there is none. */
export function readObjects(names: readonly string[]): (Uint8Array | null)[] {
  if (names.length === 0) return [];
  const bytes = git(['cat-file', '--batch'], `${names.join('\n')}\n`);
  const objects: (Uint8Array | null)[] = [];
  for (let at = 0; at < bytes.length; ) {
    const end = bytes.indexOf(10, at);
    const size = /^\S+ blob (\d+)$/.exec(bytes.toString('utf8', at, end))?.[1];
    at = end + 1;
    if (size === undefined) {
      objects.push(null);
      continue;
    }
    objects.push(bytes.subarray(at, at + Number(size)));
    at += Number(size) + 1;
  }
  return objects;
}

/** The root of the repository, with `/`; null outside of one. @throws Failure for one without a working tree */
export function repositoryRoot(): string | null {
  const inside = gitOrNull(['rev-parse', '--is-inside-work-tree']);
  if (inside === null) return null;
  const root = inside === 'true' ? gitOrNull(['rev-parse', '--show-toplevel']) : null;
  if (root !== null) return root;
  throw new Failure('this is not a working tree: run gq diff in a clone with files, or give two files or two folders');
}

/** The tree of a revision; null if there is no such revision. */
export const treeOf = (revision: string): string | null =>
  revision.startsWith('-') ? null : gitOrNull(['rev-parse', '--verify', '--quiet', '--end-of-options', `${revision}^{tree}`]);

/** Advice where history may be missing. */
export function shallowHint(): string {
  if (gitOrNull(['rev-parse', '--is-shallow-repository']) !== 'true') return '';
  return '; this clone is shallow: git fetch --unshallow gets its history (in GitHub Actions: fetch-depth: 0)';
}

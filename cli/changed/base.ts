import { existsSync } from 'node:fs';
import process from 'node:process';
import { Failure } from '../failure.ts';
import { shellPath } from '../shown-path.ts';
import { askGit } from './git.ts';

/** The commit with which files are compared. */
export interface Base {
  /** In words: `main (merge base 1a2b3c4)`. */
  readonly inWords: string;
  /** Its hash; null in a repository without a commit, where every file is new. */
  readonly commit: string | null;
}

/**
 * Where the history of the working directory leaves that of a ref.
 * @param ref null: the branch that changes go into, as far as it is known
 * @throws Failure if there is no such commit
 */
export function findBase(root: string, ref: string | null): Base {
  const isCommit = (name: string): boolean => askGit(root, ['rev-parse', '--verify', '--quiet', `${name}^{commit}`]).ok;
  if (!isCommit('HEAD')) {
    if (ref !== null)
      throw new Failure(`--changed ${ref}: the repository has no commit yet; --changed without a ref checks all its levels`);
    return { inWords: 'the beginning, as there is no commit yet', commit: null };
  }
  const name = ref ?? defaultBranch(root, isCommit);
  if (ref !== null && (ref.startsWith('-') || !isCommit(ref))) throw new Failure(unknownRef(root, ref));
  const { ok, output } = askGit(root, ['merge-base', name, 'HEAD']);
  if (!ok) {
    throw new Failure(
      `--changed: ${name} and the commit that is checked out have no common commit${isShallow(root) ? `: ${SHALLOW}` : ''}`,
    );
  }
  const commit = output.trim();
  return {
    inWords: name === 'HEAD' ? `the last commit (${commit.slice(0, 7)})` : `${name} (merge base ${commit.slice(0, 7)})`,
    commit,
  };
}

const SHALLOW =
  'this clone is shallow, so its history ends too early: fetch more of it (git fetch --unshallow; with actions/checkout, fetch-depth: 0)';

const isShallow = (root: string): boolean => askGit(root, ['rev-parse', '--is-shallow-repository']).output.trim() === 'true';

/** The branch that a pull request goes into, that of the remote, or a local one with the usual name; else the last commit. */
function defaultBranch(root: string, isCommit: (name: string) => boolean): string {
  // GitHub and GitLab name it for a pull request; a value that is set must not be passed over
  const asked = process.env.GITHUB_BASE_REF || process.env.CI_MERGE_REQUEST_TARGET_BRANCH_NAME;
  if (asked) {
    const found = [`refs/remotes/origin/${asked}`, `refs/heads/${asked}`].find(isCommit);
    if (found === undefined) {
      throw new Failure(
        `--changed: the branch ${asked}, into which this pull request goes, is not there${isShallow(root) ? `: ${SHALLOW}` : `: git fetch origin ${asked} gets it`}`,
      );
    }
    return shortName(found);
  }
  const { ok, output } = askGit(root, ['symbolic-ref', '--quiet', 'refs/remotes/origin/HEAD']);
  const named = ok ? [output.trim()] : [];
  const usual = ['refs/remotes/origin/main', 'refs/remotes/origin/master', 'refs/heads/main', 'refs/heads/master'];
  return shortName([...named, ...usual].find(isCommit) ?? 'HEAD');
}

const shortName = (ref: string): string => ref.replace(/^refs\/(remotes|heads)\//, '');

function unknownRef(root: string, ref: string): string {
  const what = `--changed ${shellPath(ref)}: there is no commit of that name`;
  if (existsSync(ref)) {
    const path = shellPath(ref);
    return `${what}, but a path: to check what has changed below it, write gq check ${path} --changed, or --changed=REF ${path}`;
  }
  if (isShallow(root)) return `${what}; ${SHALLOW}`;
  return `${what}: expected a branch, a tag or a commit, as git branch --all and git tag list them`;
}

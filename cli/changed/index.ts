import { realpathSync } from 'node:fs';
import { basename, dirname, join, relative, resolve, sep } from 'node:path';
import process from 'node:process';
import { plural } from '../../check/words/index.ts';
import { CONFIG_NAME, configFolders } from '../config/index.ts';
import { Git } from '../io/index.ts';
import { Failure, visibleLine } from '../terminal/index.ts';
import { findBase } from './base.ts';

const GIT = new Git('.', '--changed', 'name the levels to check');

/** The files to check, and why these, in words. */
interface ChangedFiles {
  readonly files: readonly string[];
  readonly inWords: string;
}

/** Files besides the levels that decide on results; null: there is none. */
interface Deciding {
  /** The configuration that is used. */
  readonly config: string | null;
  /** The lock with which levels are compared. */
  readonly lock: string | null;
}

/**
 * Chooses the files that differ from a commit: changed, staged, renamed or new, whether committed or not. When a configuration that
 * applies here has changed, these are all files, because its rules may change every result. A file whose entry in the lock differs is
 * among them, too. Where nothing tells what has changed, these are all files as well.
 * @param files the files that could be checked
 * @param ref the branch, tag or commit from which they differ; null: the branch that changes go into
 * @throws Failure if git can't say
 */
export async function changedFiles(
  files: readonly string[],
  ref: string | null,
  { config: used, lock }: Deciding,
): Promise<ChangedFiles> {
  const folder = process.cwd();
  const root = findRoot(folder);
  const git = GIT.in(root);
  const base = findBase(git, ref);
  if ('unknown' in base) return { files, inWords: `all ${plural(files.length, 'level')} checked: ${base.unknown}` };
  const { changed, folders, gone } = differences(git, root, base.commit);
  const isChanged = (path: string): boolean =>
    namesOf(path).some((name) => changed.has(name) || gone.has(name) || folders.some((below) => name.startsWith(below)));
  const found = configFolders(folder).map((at) => join(at, CONFIG_NAME));
  const config = [...found, ...(used === null ? [] : [used])].find(isChanged);
  if (config !== undefined)
    return {
      files,
      inWords: `all ${plural(files.length, 'level')} checked: ${found.includes(config) ? CONFIG_NAME : visibleLine(config)} has changed since ${base.inWords}`,
    };
  const prefix = root.endsWith(sep) ? root : root + sep;
  const isLockedAnew = lock !== null && isChanged(lock) ? await changedInLock(git, lock, root, base.commit) : () => false;
  const differs = (file: string): boolean =>
    // what git does not know of is checked
    !namesOf(file).some((path) => path.startsWith(prefix)) || isChanged(file) || isLockedAnew(file);
  const chosen = files.filter(differs);
  if (chosen.length === 0) return { files: [], inWords: `no level has changed since ${base.inWords}` };
  return { files: chosen, inWords: `${chosen.length} of ${plural(files.length, 'level')} changed since ${base.inWords}` };
}

/** The names that git may have for a file: where a link leads, and the link. */
const namesOf = (file: string): string[] => [realPath(file), resolve(realPath(dirname(file)), basename(file))];

/** Whether the entry of a file in the lock differs from that in a commit. */
async function changedInLock(git: Git, lock: string, root: string, commit: string | null): Promise<(file: string) => boolean> {
  const { changedEntries } = await import('../lock/index.ts');
  const name = relative(root, realPath(lock)).split(sep).join('/');
  const before = commit === null ? null : git.ask(['show', `${commit}:${name}`]);
  return changedEntries(lock, before?.status === 0 ? before.output.toString() : null);
}

/** The real root of the repository. */
function findRoot(folder: string): string {
  const root = GIT.in(folder).workTree();
  if (root !== null) return realPath(root);
  throw new Failure(
    '--changed asks git, and this is not a git repository: expected a working directory in one; without it, name the levels to check',
  );
}

interface Differences {
  /** Files that are there and differ. */
  readonly changed: ReadonlySet<string>;
  /** Folders that differ as a whole, as submodules and nested repositories do; each ends with a separator. */
  readonly folders: readonly string[];
  /** Files that are no longer there. */
  readonly gone: ReadonlySet<string>;
}

function differences(git: Git, root: string, commit: string | null): Differences {
  const changed = new Set<string>();
  const folders: string[] = [];
  const gone = new Set<string>();
  const add = (name: string): void => {
    const path = join(root, name);
    changed.add(path);
    if (name.endsWith('/')) folders.push(path.endsWith(sep) ? path : path + sep);
  };
  const untracked = ['ls-files', '-z', '--others', '--exclude-standard', '--full-name'];
  for (const name of names(git, commit === null ? [...untracked, '--cached'] : untracked)) add(name);
  if (commit === null) return { changed, folders, gone };
  // status and name in turn; a renamed file is a new one and one that is gone
  const options = ['--no-renames', '--no-ext-diff', '--no-relative', '--ignore-submodules=none'];
  const entries = names(git, ['diff', '-z', '--raw', '--abbrev=40', ...options, commit, '--']);
  for (let i = 0; i + 1 < entries.length; i += 2) {
    const [, mode, , , status] = entries[i].split(' ');
    const name = entries[i + 1];
    if (status.startsWith('D')) gone.add(join(root, name));
    // 160000: a submodule
    else add(mode === '160000' ? `${name}/` : name);
  }
  return { changed, folders, gone };
}

const names = (git: Git, args: readonly string[]): string[] =>
  git
    .read(args)
    .toString()
    .split('\0')
    .filter((name) => name !== '');

function realPath(path: string): string {
  try {
    return realpathSync.native(path);
  } catch {
    return resolve(path);
  }
}

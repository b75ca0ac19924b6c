import { realpathSync } from 'node:fs';
import { basename, dirname, join, relative, resolve, sep } from 'node:path';
import process from 'node:process';
import { plural } from '../../check/words/index.ts';
import { CONFIG_NAME, configFolders } from '../config-file.ts';
import { Failure } from '../failure.ts';
import { visibleLine } from '../visible.ts';
import { findBase } from './base.ts';
import { askGit } from './git.ts';

/** The files to check, and why these, in words. */
export interface ChangedFiles {
  readonly files: readonly string[];
  readonly inWords: string;
}

/** Files besides the levels that decide on results; null: there is none. */
export interface Deciding {
  /** The configuration that is used. */
  readonly config: string | null;
  /** The lock with which levels are compared. */
  readonly lock: string | null;
}

/**
 * Chooses the files that differ from a commit: changed, staged, renamed or new, whether committed or not. When a configuration that
 * applies here has changed, these are all files, because its rules may change every result. A file whose entry in the lock differs is
 * among them, too.
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
  const base = findBase(root, ref);
  const { changed, folders, gone } = differences(root, base.commit);
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
  const isLockedAnew = lock !== null && isChanged(lock) ? await changedInLock(lock, root, base.commit) : () => false;
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
async function changedInLock(lock: string, root: string, commit: string | null): Promise<(file: string) => boolean> {
  const { changedEntries } = await import('../lock/index.ts');
  const name = relative(root, realPath(lock)).split(sep).join('/');
  const before = commit === null ? null : askGit(root, ['show', `${commit}:${name}`]);
  return changedEntries(lock, before?.ok ? before.output : null);
}

/** The real root of the repository. */
function findRoot(folder: string): string {
  const { ok, output, error } = askGit(folder, ['rev-parse', '--show-toplevel']);
  const root = output.replace(/\r?\n$/, '');
  if (ok && root !== '') return realPath(root);
  throw new Failure(
    `--changed asks git, which says: ${error === '' ? 'there is no work tree here' : error}\nexpected a working directory in a git repository`,
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

function differences(root: string, commit: string | null): Differences {
  const changed = new Set<string>();
  const folders: string[] = [];
  const gone = new Set<string>();
  const add = (name: string): void => {
    const path = join(root, name);
    changed.add(path);
    if (name.endsWith('/')) folders.push(path.endsWith(sep) ? path : path + sep);
  };
  const untracked = ['ls-files', '-z', '--others', '--exclude-standard', '--full-name'];
  for (const name of names(root, commit === null ? [...untracked, '--cached'] : untracked)) add(name);
  if (commit === null) return { changed, folders, gone };
  // status and name in turn; a renamed file is a new one and one that is gone
  const options = ['--no-renames', '--no-ext-diff', '--no-relative', '--ignore-submodules=none'];
  const entries = names(root, ['diff', '-z', '--raw', '--abbrev=40', ...options, commit, '--']);
  for (let i = 0; i + 1 < entries.length; i += 2) {
    const [, mode, , , status] = entries[i].split(' ');
    const name = entries[i + 1];
    if (status.startsWith('D')) gone.add(join(root, name));
    // 160000: a submodule
    else add(mode === '160000' ? `${name}/` : name);
  }
  return { changed, folders, gone };
}

function names(root: string, args: readonly string[]): string[] {
  const { ok, output, error } = askGit(root, args);
  if (!ok) throw new Failure(`--changed: git ${args[0]} failed: ${error}`);
  return output.split('\0').filter((name) => name !== '');
}

function realPath(path: string): string {
  try {
    return realpathSync.native(path);
  } catch {
    return resolve(path);
  }
}

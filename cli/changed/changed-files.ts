import { realpathSync } from 'node:fs';
import { basename, dirname, join, resolve, sep } from 'node:path';
import process from 'node:process';
import { plural } from '../../check/words/index.ts';
import { CONFIG_NAME, configFolders } from '../config-file.ts';
import { Failure } from '../failure.ts';
import { findBase } from './base.ts';
import { askGit } from './git.ts';

/** The files to check, and why these, in words. */
export interface ChangedFiles {
  readonly files: readonly string[];
  readonly inWords: string;
}

/**
 * Chooses the files that differ from a commit: changed, staged, renamed or new, whether committed or not. When a configuration that
 * applies here has changed, these are all files, because its rules may change every result.
 * @param files the files that could be checked
 * @param ref the branch, tag or commit from which they differ; null: the branch that changes go into
 * @throws Failure if git can't say
 */
export function changedFiles(files: readonly string[], ref: string | null): ChangedFiles {
  const folder = process.cwd();
  const root = findRoot(folder);
  const base = findBase(root, ref);
  const { changed, folders, gone } = differences(root, base.commit);
  const configs = configFolders(folder).map((at) => join(at, CONFIG_NAME));
  const config = configs.find((path) => changed.has(realPath(path)) || gone.has(realPath(path)));
  if (config !== undefined)
    return { files, inWords: `all ${plural(files.length, 'level')} checked: ${CONFIG_NAME} has changed since ${base.inWords}` };
  const prefix = root.endsWith(sep) ? root : root + sep;
  const differs = (file: string): boolean => {
    const paths = [realPath(file), resolve(realPath(dirname(file)), basename(file))];
    // what git does not know of is checked
    if (!paths.some((path) => path.startsWith(prefix))) return true;
    return paths.some((path) => changed.has(path) || folders.some((below) => path.startsWith(below)));
  };
  const chosen = files.filter(differs);
  if (chosen.length === 0) return { files: [], inWords: `no level has changed since ${base.inWords}` };
  return { files: chosen, inWords: `${chosen.length} of ${plural(files.length, 'level')} changed since ${base.inWords}` };
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

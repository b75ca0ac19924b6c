import { dirname, relative, resolve, sep } from 'node:path';
import type { Configuration } from '../configuration.ts';
import { Failure } from '../failure.ts';
import { type FoundFiles, statOrError } from '../files.ts';
import { findConfigured, pathsOr } from '../level-paths.ts';
import { sortedByPlay } from '../order-of-play.ts';

/** A level file of a pack. */
export interface PackFile {
  readonly file: string;
  /** The path below the folder of the pack, with slashes, without .level.json. */
  readonly id: string;
}

/**
 * The level files of a pack, in the order in which they are played: that of the paths, and below each path by name, with numbers by
 * their value.
 * @throws Failure if a path matches none, a folder can't be read, or two files have one id
 */
export async function findPack(paths: readonly string[], configuration: Configuration): Promise<readonly PackFile[]> {
  const { files, unreadable } = await findConfigured(paths, configuration);
  if (unreadable.length > 0) {
    const list = unreadable.map(({ path, reason }) => `  ${path}: ${reason}\n`).join('');
    throw new Failure(`nothing was written, because directories can't be read:\n${list.trimEnd()}`);
  }
  const given = pathsOr(paths, configuration);
  const ordered = given.length === 1 ? inOrder(files) : await inOrderOfPaths(given, files, configuration);
  const folder = given.length === 1 && isFolder(given[0]) ? resolve(given[0]) : commonFolder(ordered);
  const owners = new Map<string, string>();
  return ordered.map((file) => {
    const id = idOf(relative(folder, resolve(file)));
    const other = owners.get(id);
    if (other !== undefined)
      throw new Failure(`${file}: expected one level ${JSON.stringify(id)}, found ${other} as well; rename one, or leave it out`);
    owners.set(id, file);
    return { file, id };
  });
}

const slashed = (path: string): string => path.split(sep).join('/');

const inOrder = (files: readonly string[]): string[] => sortedByPlay(files, slashed);

async function inOrderOfPaths(
  paths: readonly string[],
  files: readonly string[],
  configuration: Configuration,
): Promise<string[]> {
  const wanted = new Set(files);
  const ordered: string[] = [];
  for (const path of paths) {
    const found: FoundFiles = await findConfigured([path], configuration);
    // a file that two paths name counts where it is named first
    for (const file of inOrder(found.files)) if (wanted.delete(file)) ordered.push(file);
  }
  return ordered;
}

const idOf = (path: string): string => slashed(path).replace(/(?:\.level)?\.json$/, '');

const isFolder = (path: string): boolean => {
  const stats = statOrError(path);
  return !(stats instanceof Error) && stats.isDirectory();
};

/** The innermost folder that all files are in or below. */
function commonFolder(files: readonly string[]): string {
  let common = resolve(dirname(files[0])).split(sep);
  for (const file of files) {
    const parts = resolve(dirname(file)).split(sep);
    const differs = common.findIndex((part, i) => part !== parts[i]);
    if (differs >= 0) common = common.slice(0, differs);
  }
  return common.join(sep) || sep;
}

import { dirname, relative, resolve, sep } from 'node:path';
import type { Configuration } from '../configuration.ts';
import { FileFailure } from '../file-failure.ts';
import { type FoundFiles, findConfigured, pathsOr } from '../find/index.ts';
import { Failure, type FoundPack, levelIdOf, sortedByPlay, statOrError } from '../io/index.ts';
import { type CheckedPack, checkPackFile } from '../pack-file/index.ts';

/** A level file of a pack. */
export interface PackFile {
  readonly file: string;
  /** The path below the folder of the pack, with slashes, without .level.json. */
  readonly id: string;
}

/** The levels of a pack, and what says so. */
export interface FoundLevels {
  readonly files: readonly PackFile[];
  /** What the pack.json of the only path says; null if there is none. */
  readonly order: CheckedPack | null;
  /** The ids of the levels that it leaves out. */
  readonly leftOut: readonly string[];
}

/**
 * The level files of a pack, in the order in which they are played: those that the pack.json of a folder lists; where there is none,
 * that of the paths, and below each path by name, with numbers by their value.
 * @throws Failure if a path matches none, a folder can't be read, a pack.json has errors, or two files have one id
 */
export async function findPack(paths: readonly string[], configuration: Configuration): Promise<FoundLevels> {
  const { files, packs, unreadable } = await findConfigured(paths, configuration);
  if (unreadable.length > 0) {
    const list = unreadable.map(({ path, reason }) => `  ${path}: ${reason}\n`).join('');
    throw new Failure(`nothing was written, because directories can't be read:\n${list.trimEnd()}`);
  }
  const given = pathsOr(paths, configuration);
  const checked = packs.map((pack) => checkPackFile(pack, new Set(files), configuration));
  refuseErrors(checked);
  const ordered = given.length === 1 ? inOrder(files, checked.length > 0) : await inOrderOfPaths(given, files, configuration);
  const folder = given.length === 1 && isFolder(given[0]) ? resolve(given[0]) : commonFolder(ordered);
  const left = new Set(packs.flatMap((pack, i) => unlistedOf(pack, checked[i], files)));
  const owners = new Map<string, string>();
  const all = ordered.map((file) => {
    const id = levelIdOf(folder, file);
    const other = owners.get(id);
    if (other !== undefined)
      throw new Failure(`${file}: expected one level ${JSON.stringify(id)}, found ${other} as well; rename one, or leave it out`);
    owners.set(id, file);
    return { file, id };
  });
  const kept = all.filter(({ file }) => !left.has(file));
  if (kept.length === 0)
    throw new Failure(`nothing was written: ${packs[0].file} lists no level; list the levels that are played`);
  const leftOut = all.filter(({ file }) => left.has(file)).map(({ id }) => id);
  return { files: kept, order: given.length === 1 ? (checked[0] ?? null) : null, leftOut };
}

/** The files of a folder that its pack does not list. */
const unlistedOf = ({ folder }: FoundPack, { listed }: CheckedPack, files: readonly string[]): string[] =>
  files.filter((file) => isBelow(folder, file) && listed?.includes(levelIdOf(folder, file)) === false);

const isBelow = (folder: string, file: string): boolean => !relative(resolve(folder), resolve(file)).startsWith('..');

/** @throws Failure if the order of a pack has errors: a hole in the game is not built */
function refuseErrors(packs: readonly CheckedPack[]): void {
  const wrong = packs.map((pack) => ({ ...pack, problems: pack.problems.filter(({ severity }) => severity === 'error') }));
  const files = wrong.filter(({ problems }) => problems.length > 0);
  if (files.length > 0) throw new FileFailure('nothing was written, because of errors in the order of the levels', files);
}

const slashed = (path: string): string => path.split(sep).join('/');

/** @param isGiven whether a pack has put them in order already */
const inOrder = (files: readonly string[], isGiven: boolean): string[] => (isGiven ? [...files] : sortedByPlay(files, slashed));

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
    for (const file of inOrder(found.files, found.packs.length > 0)) if (wanted.delete(file)) ordered.push(file);
  }
  return ordered;
}

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

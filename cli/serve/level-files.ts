import { lstatSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { inOrderOfPlay, isShown, sortedByPlay, walk } from '../io/index.ts';
import { systemReason } from '../terminal/index.ts';

export const SUFFIX = '.level.json';

/** A level file below a folder. */
export interface LevelFileFound {
  /** The path relative to the folder, with slashes, without .level.json. */
  readonly id: string;
  readonly path: string;
  /** Whether it is a symbolic link: listed, but never followed. */
  readonly isLink: boolean;
}

export interface LevelFilesFound {
  /** The level files by id, in order of play. */
  readonly files: ReadonlyMap<string, LevelFileFound>;
  /** '' and every folder below, with slashes; without links, hidden folders and node_modules. */
  readonly folders: readonly string[];
  /** Messages about folders that could not be read. */
  readonly troubles: readonly string[];
}

/**
 * Every `*.level.json` below a folder, as it is now. The id in a request is only looked up among these files: no text of a
 * request ever becomes the path of a file that is read, moved or overwritten.
 */
export function findLevels(root: string): LevelFilesFound {
  const passes = (below: string): boolean => /[^/]\.level\.json$/.test(below);
  const { files, folders, unreadable } = walk(root, { links: 'listed', hidden: 'passed by', passes });
  const found = files.map(({ below, isLink }) => ({ id: below.slice(0, -SUFFIX.length), path: join(root, below), isLink }));
  return {
    files: new Map(sortedByPlay(found, ({ id }) => id).map((file) => [file.id, file])),
    folders: [...folders].sort(inOrderOfPlay),
    troubles: unreadable.map(({ below, error }) => `${join(root, below)}: the folder can't be read: ${systemReason(error)}`),
  };
}

/** The names in a folder, spelt as on the disk even if the system ignores case; none if the folder can't be read. */
export function namesIn(root: string, folder: string): string[] {
  try {
    return readdirSync(join(root, folder));
  } catch {
    return [];
  }
}

const isFolder = (root: string, folder: string): boolean =>
  lstatSync(join(root, folder), { throwIfNoEntry: false })?.isDirectory() === true;

/** The folders below `root` whose names all pass when compared with the parts of `folder`. */
function foldersLike(root: string, folder: string, passes: (name: string, wanted: string) => boolean): string[] {
  let found = [''];
  for (const part of folder === '' ? [] : folder.split('/')) {
    found = found.flatMap((above) =>
      namesIn(root, above)
        .filter((name) => isShown(name) && passes(name, part))
        .map((name) => joinId(above, name))
        .filter((below) => isFolder(root, below)),
    );
  }
  return found;
}

/** Whether this is an existing folder that may contain levels: not a link, and not hidden. */
export const hasFolder = (root: string, folder: string): boolean =>
  foldersLike(root, folder, (name, wanted) => name === wanted).length > 0;

/** The level file of one id as `findLevels` finds it, but without listing all the others. */
export function findLevel(root: string, id: string): LevelFileFound | undefined {
  const { folder, name } = splitId(id);
  // an id has one spelling: /a is not a
  if (name === '' || joinId(folder, name) !== id || !hasFolder(root, folder) || !namesIn(root, folder).includes(name + SUFFIX))
    return undefined;
  const path = pathOfNew(root, folder, name);
  const stats = lstatSync(path, { throwIfNoEntry: false });
  if (stats === undefined || !(stats.isFile() || stats.isSymbolicLink())) return undefined;
  return { id, path, isLink: stats.isSymbolicLink() };
}

/** The ids of level files that differ from this one at most by the case of letters. */
export function findLike(root: string, id: string): string[] {
  const { folder, name } = splitId(id);
  const isLike = (a: string, b: string): boolean => a.toLowerCase() === b.toLowerCase();
  return foldersLike(root, folder, isLike).flatMap((at) =>
    namesIn(root, at)
      .filter((other) => isLike(other, name + SUFFIX) && other.endsWith(SUFFIX))
      .map((other) => joinId(at, other.slice(0, -SUFFIX.length))),
  );
}

/** The path of a new level file. @param folder one that `findLevels` has found @param name matches `LEVEL_ID_PART` */
export const pathOfNew = (root: string, folder: string, name: string): string => join(root, folder, name + SUFFIX);

/** The folder of an id ('' for the root) and the name in it. */
export function splitId(id: string): { folder: string; name: string } {
  const slash = id.lastIndexOf('/');
  return { folder: slash < 0 ? '' : id.slice(0, slash), name: id.slice(slash + 1) };
}

export const joinId = (folder: string, name: string): string => (folder === '' ? name : `${folder}/${name}`);

import { type Dirent, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { systemReason } from '../failure.ts';

const SUFFIX = '.level.json';

/** A level file below a folder. */
export interface LevelFileFound {
  /** Path below the folder, with slashes, without .level.json. */
  readonly id: string;
  readonly path: string;
  /** A symbolic link: it is listed and never followed. */
  readonly isLink: boolean;
}

export interface LevelFilesFound {
  /** By id, in the order of play. */
  readonly files: ReadonlyMap<string, LevelFileFound>;
  /** '' and every real folder below, with slashes; not those that are hidden, nor node_modules. */
  readonly folders: readonly string[];
  /** Folders that could not be looked into, for people. */
  readonly troubles: readonly string[];
}

/**
 * Every `*.level.json` below a folder, as it is now. An id that a request names is looked up here and nowhere else: no text that
 * comes from outside is ever made into a path of a file that is read, moved or overwritten.
 */
export function findLevels(root: string): LevelFilesFound {
  const files: LevelFileFound[] = [];
  const folders: string[] = [];
  const troubles: string[] = [];
  const pending = [''];
  for (let folder = pending.pop(); folder !== undefined; folder = pending.pop()) {
    const directory = join(root, folder);
    let entries: Dirent[];
    try {
      entries = readdirSync(directory, { withFileTypes: true });
    } catch (error) {
      troubles.push(`${directory}: can't be looked into: ${systemReason(error)}`);
      continue;
    }
    folders.push(folder);
    for (const entry of entries) {
      const below = folder === '' ? entry.name : `${folder}/${entry.name}`;
      const isFile = entry.isFile() || entry.isSymbolicLink();
      if (isFile && entry.name.endsWith(SUFFIX) && entry.name.length > SUFFIX.length) {
        files.push({ id: below.slice(0, -SUFFIX.length), path: join(root, below), isLink: entry.isSymbolicLink() });
      } else if (entry.isDirectory() && !entry.name.startsWith('.') && entry.name !== 'node_modules') pending.push(below);
    }
  }
  files.sort((a, b) => inOrderOfPlay(a.id, b.id));
  return { files: new Map(files.map((file) => [file.id, file])), folders: folders.sort(inOrderOfPlay), troubles };
}

/** Where the file of an id that `LEVEL_ID_PART` lets pass is put, in a folder that `findLevels` has found. */
export const pathOfNew = (root: string, folder: string, name: string): string => join(root, folder, name + SUFFIX);

/** The folder of an id ('' for the outermost), and the name in it. */
export function splitId(id: string): { folder: string; name: string } {
  const slash = id.lastIndexOf('/');
  return { folder: slash < 0 ? '' : id.slice(0, slash), name: id.slice(slash + 1) };
}

export const joinId = (folder: string, name: string): string => (folder === '' ? name : `${folder}/${name}`);

// en: the order must not hang on the language of the machine
const collator = new Intl.Collator('en', { numeric: true });

/** By folders and names, numbers by their value: `2-b` before `10-a`. */
export function inOrderOfPlay(a: string, b: string): number {
  const [left, right] = [a.split('/'), b.split('/')];
  for (let i = 0; i < Math.min(left.length, right.length); i++) {
    const order = collator.compare(left[i], right[i]) || (left[i] < right[i] ? -1 : left[i] > right[i] ? 1 : 0);
    if (order !== 0) return order;
  }
  return left.length - right.length;
}

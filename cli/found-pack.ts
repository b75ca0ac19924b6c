import { lstatSync, type Stats, statSync } from 'node:fs';
import { basename, relative, resolve, sep } from 'node:path';

// What needs no schema, which takes as long to load as starting node; the rest is in pack-file/.

/** The name of the file that says in which order the levels of its folder are played. */
const PACK_NAME = 'pack.json';

/** A pack file in a folder that a path names. */
export interface FoundPack {
  readonly file: string;
  /** The folder as the path names it. */
  readonly folder: string;
  /** All level files below the folder, also those that a configuration leaves out. */
  readonly levels: readonly string[];
}

/** What a command says of a pack file where it expects a level. */
export const NOT_A_LEVEL =
  'it says in which order the levels of its folder are played, and is no level: give the folder, or a level';

/** Whether a file is the order of a pack by its name, and so no level. */
export const isPackFile = (file: string): boolean => basename(file) === PACK_NAME;

/** The pack file of a folder; null if there is none. */
export function packFileOf(folder: string): string | null {
  const file = folder === '.' ? PACK_NAME : `${folder}${folder.endsWith('/') ? '' : '/'}${PACK_NAME}`;
  // a broken link is kept: reading it reports the error
  return statsOf(file)?.isDirectory() === false ? file : null;
}

function statsOf(path: string): Stats | undefined {
  try {
    return statSync(path, { throwIfNoEntry: false }) ?? lstatSync(path, { throwIfNoEntry: false });
  } catch {
    return undefined;
  }
}

/** The id of a level file: its path below the folder, with slashes, without .level.json. */
export const levelIdOf = (folder: string, file: string): string =>
  relative(resolve(folder), resolve(file))
    .split(sep)
    .join('/')
    .replace(/(?:\.level)?\.json$/, '');

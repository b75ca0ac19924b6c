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

/** The name of a level file without its ending. */
export const nameOfFile = (file: string): string => basename(file).replace(/(\.level)?\.json$/, '');

/** Made when it is needed first, because that takes longer than the check of a level; `en`, whatever the language of the machine. */
let collator: Intl.Collator | null = null;

/** Compares paths with slashes by folder, then by name, with numbers by value: `2-b` before `10-a`. */
export const inOrderOfPlay = (a: string, b: string): number => comparePaths(a.split('/'), b.split('/'));

/** Sorts by path. Splits each path only once: splitting at every comparison would take most of the time of a long sort. */
export function sortedByPlay<T>(things: readonly T[], pathOf: (thing: T) => string): T[] {
  const keyed = things.map((thing) => ({ thing, parts: pathOf(thing).split('/') }));
  keyed.sort((a, b) => comparePaths(a.parts, b.parts));
  return keyed.map(({ thing }) => thing);
}

function comparePaths(left: readonly string[], right: readonly string[]): number {
  collator ??= new Intl.Collator('en', { numeric: true });
  for (let i = 0; i < Math.min(left.length, right.length); i++) {
    const order = collator.compare(left[i], right[i]) || (left[i] < right[i] ? -1 : left[i] > right[i] ? 1 : 0);
    if (order !== 0) return order;
  }
  return left.length - right.length;
}

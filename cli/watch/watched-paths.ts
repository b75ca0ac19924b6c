import { statSync } from 'node:fs';
import { basename, dirname, join, resolve, sep } from 'node:path';
import { CONFIG_NAME, configFolders } from '../config-file.ts';

/** What is watched: folders with all below them, and single files. */
export interface WatchedPaths {
  /** The folders at which watching begins. They contain what is watched, so that it may vanish and come back. */
  readonly roots: readonly string[];
  /** Whether changes of a path, or below it, matter. */
  matters(path: string): boolean;
}

const isFolder = (path: string): boolean => statSync(path, { throwIfNoEntry: false })?.isDirectory() === true;

/** What of the paths of a check may change its reports. @param files single files besides, such as the lock */
export function watchedPaths(paths: readonly string[], files: readonly string[]): WatchedPaths {
  const folders: string[] = [];
  const single = [...files, ...configFolders('.').map((folder) => join(folder, CONFIG_NAME))].map((path) => resolve(path));
  for (const path of paths) {
    if (isFolder(path)) folders.push(resolve(path));
    else if (/[*?]/.test(path) && statSync(path, { throwIfNoEntry: false }) === undefined)
      folders.push(resolve(fixedFolder(path)));
    else single.push(resolve(path));
  }
  const wanted = [...folders, ...single];
  return {
    // the folder around each, as far as none contains another
    roots: withoutInner(wanted.map((path) => nearestFolder(dirname(path)))),
    matters(path) {
      const full = resolve(path);
      if (single.includes(full)) return true;
      // the way to what is wanted
      if (wanted.some((one) => full === one || one.startsWith(withSeparator(full)))) return true;
      return folders.some((folder) => full.startsWith(withSeparator(folder)) && !isHidden(full.slice(folder.length + 1)));
    },
  };
}

const withSeparator = (folder: string): string => (folder.endsWith(sep) ? folder : folder + sep);

const isHidden = (inner: string): boolean => inner.split(sep).some((name) => name.startsWith('.') || name === 'node_modules');

function fixedFolder(pattern: string): string {
  const fixed = pattern.slice(0, pattern.search(/[*?]/));
  return basename(fixed) === fixed && !/[\\/]$/.test(fixed) ? '.' : dirname(`${fixed}x`);
}

/** A folder that exists: this one, or the nearest around it. */
const nearestFolder = (folder: string): string =>
  isFolder(folder) || dirname(folder) === folder ? folder : nearestFolder(dirname(folder));

function withoutInner(folders: readonly string[]): string[] {
  const all = [...new Set(folders)];
  return all.filter((folder) => !all.some((other) => other !== folder && folder.startsWith(withSeparator(other))));
}

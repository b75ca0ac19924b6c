import { mkdirSync, statSync } from 'node:fs';
import { dirname } from 'node:path';

/**
 * Makes a folder and those above it that are missing. As `mkdirSync` with `recursive`, which never ends where the system says of a
 * new folder that it does not exist though the one above it does, as in /proc (seen with Node 20.20).
 * @returns the outermost folder that was made; undefined if the folder is there already
 * @throws system errors
 */
export function makeFolders(folder: string): string | undefined {
  if (isFolder(folder)) return undefined;
  const above = dirname(folder);
  const outermost = above === folder ? undefined : makeFolders(above);
  try {
    mkdirSync(folder);
  } catch (error) {
    // another process may have made it
    if (!isFolder(folder)) throw error;
  }
  return outermost ?? folder;
}

const isFolder = (path: string): boolean => statSync(path, { throwIfNoEntry: false })?.isDirectory() === true;

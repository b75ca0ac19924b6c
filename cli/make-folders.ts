import { mkdirSync, statSync } from 'node:fs';
import { dirname } from 'node:path';

/**
 * Makes a folder and those above it that are missing. As `mkdirSync` with `recursive`, which never ends where the system says of a
 * new folder that it does not exist though the one above it does, as in /proc (seen with Node 20.20).
 * @returns the outermost folder that was made; undefined if the folder is there already
 * @throws system errors
 */
export function makeFolders(folder: string): string | undefined {
  if (isMade(folder)) return folder;
  if (isFolder(folder)) return undefined;
  const outermost = makeFolders(dirname(folder));
  // another process may make it, too
  if (!isFolder(folder)) makeOne(folder);
  return outermost ?? folder;
}

/** Whether a folder was made; false if it is there, or those above it are missing. */
function isMade(folder: string): boolean {
  try {
    mkdirSync(folder);
    return true;
  } catch (error) {
    if (isFolder(folder)) return false;
    if ((error as NodeJS.ErrnoException).code === 'ENOENT' && dirname(folder) !== folder) return false;
    throw error;
  }
}

function makeOne(folder: string): void {
  try {
    mkdirSync(folder);
  } catch (error) {
    if (!isFolder(folder)) throw error;
  }
}

const isFolder = (path: string): boolean => statSync(path, { throwIfNoEntry: false })?.isDirectory() === true;

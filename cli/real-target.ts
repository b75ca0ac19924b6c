import { lstatSync, readlinkSync, realpathSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';

/** Links that are followed at most, as many as Linux follows. */
const MOST_LINKS = 40;

/**
 * Where writing to a path leads: absolute, without symbolic links, whether or not it exists. The same text for paths that lead to the
 * same place.
 * @throws system errors, such as ELOOP
 */
export const realTarget = (path: string): string => follow(resolve(path), MOST_LINKS);

function follow(path: string, left: number): string {
  try {
    return realpathSync(path);
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    if ((code !== 'ENOENT' && code !== 'ENOTDIR') || left === 0) throw error;
  }
  const above = dirname(path);
  if (above === path) return path;
  const folder = follow(above, left);
  // the link is broken: a file that is written through it comes to where it leads
  return isLink(path) ? follow(resolve(folder, readlinkSync(path)), left - 1) : join(folder, basename(path));
}

function isLink(path: string): boolean {
  try {
    return lstatSync(path, { throwIfNoEntry: false })?.isSymbolicLink() === true;
  } catch (error) {
    // a part of the path is a file, so there is nothing
    if ((error as NodeJS.ErrnoException).code === 'ENOTDIR') return false;
    throw error;
  }
}

import { resolve, sep } from 'node:path';
import { statOrError } from '../io/index.ts';
import { lockedFile, type OpenedLock } from './lock-file.ts';

/** The part of a path before its first special character, up to a whole folder. */
const fixedPart = (path: string): string => {
  const at = path.search(/[*?]/);
  if (at < 0 || !(statOrError(path) instanceof Error)) return path;
  return path.slice(0, path.split(sep).join('/').lastIndexOf('/', at) + 1) || '.';
};

/**
 * Whether a level file is gone that paths would have found: nothing is there, and its place is one of the paths or below one.
 * Of a pattern, the folder before the first `*` or `?` counts.
 */
export function goneUnder(paths: readonly string[]): (levelFile: string) => boolean {
  const roots = paths.map((path) => resolve(fixedPart(path)));
  return (levelFile) => {
    const full = resolve(levelFile);
    const isUnder = roots.some((root) => full === root || full.startsWith(root.endsWith(sep) ? root : root + sep));
    if (!isUnder) return false;
    const stats = statOrError(levelFile);
    return stats instanceof Error && ['ENOENT', 'ENOTDIR'].includes((stats as NodeJS.ErrnoException).code ?? '');
  };
}

/** The entries of a lock whose level files are gone, in words for people; '' if there are none. */
export function goneInWords({ file, lock, lineOf }: OpenedLock, isGone: (levelFile: string) => boolean): string {
  return Object.keys(lock.levels)
    .filter((key) => isGone(lockedFile(file, key)))
    .map((key) => `warning: ${file}:${lineOf(key)}: the level ${key} is gone; gq check --update-lock removes its entry\n`)
    .join('');
}

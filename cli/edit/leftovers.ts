import { lstatSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { moveFile, UNFINISHED } from '../io/index.ts';
import { namesIn, pathOfNew } from './level-files.ts';
import { ASIDE } from './one-at-a-time.ts';
import { makeStampFolder, TRASH } from './trash.ts';

/**
 * Cleans up after processes that were killed. Unfinished files were never acknowledged, but may contain somebody's work: they
 * go to the trash unless they are empty. Locks that were moved aside are deleted.
 * @param age ms; younger files may belong to a process that is still running
 */
export function collectLeftovers(root: string, folders: readonly string[], now: Date, age: number): void {
  let stamp: string | null = null;
  // the absolute difference: a time in the future comes from a wrong clock and counts as old
  const isOld = (path: string, touched: 'mtimeMs' | 'ctimeMs'): boolean => {
    const stats = lstatSync(path, { throwIfNoEntry: false });
    return stats?.isFile() === true && Math.abs(now.getTime() - stats[touched]) > age;
  };
  for (const folder of [...folders, TRASH]) {
    for (const name of namesIn(root, folder)) {
      const path = join(root, folder, name);
      // ctime is when the lock was moved aside; its mtime is older
      if (folder === '' && ASIDE.test(name) && isOld(path, 'ctimeMs')) rmSync(path, { force: true });
      if (!UNFINISHED.test(name) || !isOld(path, 'mtimeMs')) continue;
      if (folder === TRASH || lstatSync(path).size === 0) rmSync(path, { force: true });
      else {
        stamp ??= makeStampFolder(root, now);
        moveFile(path, pathOfNew(join(root, TRASH, stamp), '', `unfinished-${name.slice(9, -4)}`));
      }
    }
  }
}

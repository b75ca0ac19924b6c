import { lstatSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { moveFile, UNFINISHED } from '../disk.ts';
import { namesIn, pathOfNew } from './level-files.ts';
import { ASIDE } from './one-at-a-time.ts';
import { makeStampFolder, TRASH } from './trash.ts';

/**
 * Cleans up behind processes that were killed. What one had begun to write was never acknowledged, but is perhaps somebody's work: it goes
 * to the trash, but for what is empty. A lock that was moved aside is of no use to anybody.
 * @param age ms: what was touched later may be another process's that is at work
 */
export function collectLeftovers(root: string, folders: readonly string[], now: Date, age: number): void {
  let stamp: string | null = null;
  // a time to come is no time
  const isOld = (path: string, touched: 'mtimeMs' | 'ctimeMs'): boolean => {
    const stats = lstatSync(path, { throwIfNoEntry: false });
    return stats?.isFile() === true && Math.abs(now.getTime() - stats[touched]) > age;
  };
  for (const folder of [...folders, TRASH]) {
    for (const name of namesIn(root, folder)) {
      const path = join(root, folder, name);
      // a lock is old when it is moved aside: what counts is when that was
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

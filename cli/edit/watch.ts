import { type FSWatcher, lstatSync, watch } from 'node:fs';
import { basename, join, sep } from 'node:path';
import process from 'node:process';
import { systemReason } from '../failure.ts';
import type { KnownLevels } from './known-levels.ts';
import { SUFFIX } from './level-files.ts';

/** ms from the first change until the folder is looked at: a checkout touches many files, and one file more than once */
const PATIENCE = 60;

/** Linux tells of a folder what happens to the files in it; others of all that is below it, too. */
const TELLS_OF_ALL = process.platform === 'darwin' || process.platform === 'win32';

/**
 * Looks at a folder, or at single files, whenever something there has changed. What is not seen this way is seen at the next save or load of the list.
 * @returns how to end it
 */
export function watchFolder(root: string, known: KnownLevels): () => void {
  const watchers = new Map<string, { readonly watcher: FSWatcher; readonly inode: number }>();
  let touched = new Set<string>();
  let lookAtAll = false;
  let timer: NodeJS.Timeout | null = null;
  let isOver = false;

  const look = async (): Promise<void> => {
    const ids = touched;
    const all = lookAtAll;
    timer = null;
    touched = new Set();
    lookAtAll = false;
    if (!all) return known.announce([...ids], null);
    await known.refresh();
    if (!isOver) followFolders();
  };

  const heard = (folder: string, name: string | null): void => {
    const below = name === null ? null : join(folder, name).split(sep).join('/');
    if (below === null) lookAtAll = true;
    else if (below.endsWith(SUFFIX)) touched.add(below.slice(0, -SUFFIX.length));
    // a folder, perhaps; those that are hidden are of no interest
    else if (!below.split('/').some((part) => part.startsWith('.') || part === 'node_modules')) lookAtAll = true;
    if (lookAtAll || touched.size > 0) timer ??= setTimeout(() => look().catch(fail), PATIENCE);
  };

  const fail = (error: unknown): void =>
    known.addTrouble(`changes by other programs may be seen late: the folder can't be watched: ${systemReason(error)}`);

  const follow = (folder: string): void => {
    const path = join(root, folder);
    const inode = lstatSync(path, { throwIfNoEntry: false })?.ino;
    const old = watchers.get(folder);
    if (old?.inode === inode) return;
    old?.watcher.close();
    watchers.delete(folder);
    if (inode === undefined) return;
    try {
      const watcher = watch(path, { persistent: false, recursive: TELLS_OF_ALL }, (_, name) => {
        // that the folder itself was moved is reported under its own name
        heard(folder, name === basename(path) ? null : name);
      });
      watcher.on('error', fail);
      watchers.set(folder, { watcher, inode });
    } catch (error) {
      fail(error);
    }
  };

  const followFolders = (): void => {
    const folders = TELLS_OF_ALL ? [''] : known.list().folders;
    const wanted = new Set(['', ...folders]);
    for (const [folder, { watcher }] of watchers) {
      if (wanted.has(folder)) continue;
      watcher.close();
      watchers.delete(folder);
    }
    for (const folder of wanted) follow(folder);
  };

  followFolders();
  // what happened before somebody watched
  lookAtAll = true;
  timer = setTimeout(() => look().catch(fail), PATIENCE);
  return () => {
    isOver = true;
    if (timer !== null) clearTimeout(timer);
    for (const { watcher } of watchers.values()) watcher.close();
  };
}

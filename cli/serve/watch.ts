import { type FSWatcher, lstatSync, watch } from 'node:fs';
import { basename, dirname, join, sep } from 'node:path';
import process from 'node:process';
import { PACK_NAME } from '../../schema/index.ts';
import { CONFIG_NAME, type ConfigOptions, configFolders } from '../config/index.ts';
import { systemReason } from '../terminal/index.ts';
import type { KnownLevels } from './known-levels.ts';
import { SUFFIX } from './level-files.ts';

/**
 * ms from the first change until the folder or the configuration is read: a checkout changes many files, some more than once, and
 * the program that writes a file may not have finished
 */
const PATIENCE = 60;

/** Whether the system can watch a folder with everything below it. Linux reports only changes of the files directly in it. */
const IS_RECURSIVE = process.platform === 'darwin' || process.platform === 'win32';

/**
 * Reads changed files, or the whole folder, again whenever something in it changes. A change that goes unnoticed shows at the
 * next save or load of the list.
 * @returns a function that stops it
 */
export function watchFolder(root: string, known: KnownLevels): () => void {
  const watchers = new Map<string, { readonly watcher: FSWatcher; readonly inode: number }>();
  let touched = new Set<string>();
  let lookAtAll = false;
  let lookAtPack = false;
  let timer: NodeJS.Timeout | null = null;
  let isOver = false;

  const look = async (): Promise<void> => {
    const ids = touched;
    const all = lookAtAll;
    const pack = lookAtPack;
    timer = null;
    touched = new Set();
    lookAtAll = false;
    lookAtPack = false;
    if (pack && !all) known.refreshPack(null);
    if (!all) return known.announce([...ids], null);
    await known.refresh();
    if (!isOver) followFolders();
  };

  const heard = (folder: string, name: string | null): void => {
    const below = name === null ? null : join(folder, name).split(sep).join('/');
    if (below === null) lookAtAll = true;
    else if (below === PACK_NAME) lookAtPack = true;
    else if (below.endsWith(SUFFIX)) touched.add(below.slice(0, -SUFFIX.length));
    // it may be a folder; hidden ones do not matter
    else if (!below.split('/').some((part) => part.startsWith('.') || part === 'node_modules')) lookAtAll = true;
    if (lookAtAll || lookAtPack || touched.size > 0) timer ??= setTimeout(() => look().catch(fail), PATIENCE);
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
      const watcher = watch(path, { persistent: false, recursive: IS_RECURSIVE }, (_, name) => {
        // an event with the folder's own name means that the folder itself was moved
        heard(folder, name === basename(path) ? null : name);
      });
      watcher.on('error', fail);
      watchers.set(folder, { watcher, inode });
    } catch (error) {
      fail(error);
    }
  };

  const followFolders = (): void => {
    const folders = IS_RECURSIVE ? [''] : known.list().folders;
    const wanted = new Set(['', ...folders]);
    for (const [folder, { watcher }] of watchers) {
      if (wanted.has(folder)) continue;
      watcher.close();
      watchers.delete(folder);
    }
    for (const folder of wanted) follow(folder);
  };

  followFolders();
  // finds changes that happened before the watchers started
  lookAtAll = true;
  timer = setTimeout(() => look().catch(fail), PATIENCE);
  return () => {
    isOver = true;
    if (timer !== null) clearTimeout(timer);
    for (const { watcher } of watchers.values()) watcher.close();
  };
}

/**
 * Reads the terms of the configuration again when it may have changed: it may appear or vanish in any folder of the search. A
 * change that goes unnoticed shows at the next load of the list.
 * @param folder the search for the configuration starts here and goes upwards
 * @param config a file to watch instead, or false for none
 * @returns a function that stops it
 */
export function watchConfig(
  folder: string,
  known: Pick<KnownLevels, 'refreshTerms'>,
  config?: ConfigOptions['config'],
): () => void {
  if (config === false) return () => {};
  const isNamed = typeof config === 'string';
  const watched = isNamed ? basename(config) : CONFIG_NAME;
  let timer: NodeJS.Timeout | null = null;
  const look = (): void => {
    timer = null;
    known.refreshTerms();
  };
  const watchers = (isNamed ? [dirname(config)] : configFolders(folder)).flatMap((at): FSWatcher[] => {
    try {
      const watcher = watch(at, { persistent: false }, (_, name) => {
        if (name === null || name === watched) timer ??= setTimeout(look, PATIENCE);
      });
      // the folder is gone or can't be watched: its changes go unnoticed
      watcher.on('error', () => watcher.close());
      return [watcher];
    } catch {
      return [];
    }
  });
  return () => {
    if (timer !== null) clearTimeout(timer);
    for (const watcher of watchers) watcher.close();
  };
}

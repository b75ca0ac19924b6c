import { lstatSync, mkdirSync, readdirSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import type { TrashEntry } from '../../schema/index.ts';
import { createFile, isTaken, makeFolders, moveFile, UNFINISHED } from '../io/index.ts';
import { findLevels, type LevelFileFound, namesIn, pathOfNew, splitId } from './level-files.ts';
import { ASIDE } from './one-at-a-time.ts';
import { Refusal } from './refusal.ts';

/** Contains a folder for each deletion: `.gq-trash/2026-01-31T12-00-00.000Z/world-2/01-start.level.json`. */
const TRASH = '.gq-trash';

const STAMP = /^(\d{4}-\d\d-\d\d)T(\d\d)-(\d\d)-(\d\d\.\d{3}Z)(?:_\d+)?$/;

/** The levels in `.gq-trash`, the last deleted first. */
export function findTrash(root: string): { entry: TrashEntry; file: LevelFileFound }[] {
  const found: { entry: TrashEntry; file: LevelFileFound }[] = [];
  if (!isRealFolder(join(root, TRASH))) return found;
  for (const stamp of readdirSync(join(root, TRASH)).sort().reverse()) {
    const time = STAMP.exec(stamp);
    const folder = join(root, TRASH, stamp);
    if (time === null || !isRealFolder(folder)) continue;
    const deleted = `${time[1]}T${time[2]}:${time[3]}:${time[4]}`;
    for (const file of findLevels(folder).files.values()) {
      if (!file.isLink) found.push({ entry: { trash: `${stamp}/${file.id}`, id: file.id, deleted }, file });
    }
  }
  return found;
}

/** Moves a level to the trash. @throws system errors */
export function moveToTrash(root: string, { id, path }: LevelFileFound, now: Date): TrashEntry {
  const stamp = makeStampFolder(root, now);
  const { folder, name } = splitId(id);
  const to = pathOfNew(join(root, TRASH, stamp), folder, name);
  makeFolders(dirname(to));
  if (!moveFile(path, to)) throw new Error(`${to} was created in the meantime`);
  return { trash: `${stamp}/${id}`, id, deleted: now.toISOString() };
}

/** Makes a new folder for a deletion, so that names in the trash never clash. */
export function makeStampFolder(root: string, now: Date): string {
  const trash = join(root, TRASH);
  if (!isRealFolder(trash)) {
    if (lstatSync(trash, { throwIfNoEntry: false }) !== undefined) {
      throw new Refusal(
        'not-writable',
        `${trash} is not a folder`,
        'Deleted levels are kept there: move away what is in its place.',
      );
    }
    mkdirSync(trash);
  }
  // keeps deleted levels out of commits
  if (!isTaken(join(trash, '.gitignore'))) createFile(join(trash, '.gitignore'), Buffer.from('*\n'));
  const stamp = now.toISOString().replaceAll(':', '-');
  for (let n = 1; ; n++) {
    const name = n === 1 ? stamp : `${stamp}_${n}`;
    try {
      mkdirSync(join(trash, name));
      return name;
    } catch (error) {
      if ((error as NodeJS.ErrnoException).code !== 'EEXIST') throw error;
    }
  }
}

function isRealFolder(path: string): boolean {
  return lstatSync(path, { throwIfNoEntry: false })?.isDirectory() === true;
}

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

import { randomBytes } from 'node:crypto';
import {
  closeSync,
  fchmodSync,
  fchownSync,
  fsyncSync,
  linkSync,
  lstatSync,
  openSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join } from 'node:path';
import process from 'node:process';

// everything here is synchronous: a signal is handled, and another request served, only before or after a change, never in the middle of it

/** Whether anything, a broken link too, stands at a path. */
export const isTaken = (path: string): boolean => lstatSync(path, { throwIfNoEntry: false }) !== undefined;

/** The name of a file that is not finished; a process that was killed leaves one behind. */
export const UNFINISHED = /^\.gq-edit-[0-9a-f]{16}\.tmp$/;

/**
 * Writes a content beside the place where it will stand, whole and on the disk, then hands it to `place`.
 * @param place moves the file; what it throws leaves everything as it was
 */
function withUnfinished(path: string, content: Uint8Array, place: (unfinished: string) => void): void {
  const unfinished = join(dirname(path), `.gq-edit-${randomBytes(8).toString('hex')}.tmp`);
  try {
    const descriptor = openSync(unfinished, 'wx', 0o666);
    try {
      keepOwnerAndMode(descriptor, path);
      // all of it or an error: one write to a disk that is nearly full may write less than it was given
      writeFileSync(descriptor, content);
      fsyncSync(descriptor);
    } finally {
      closeSync(descriptor);
    }
    place(unfinished);
  } finally {
    rmSync(unfinished, { force: true });
  }
  syncFolder(dirname(path));
}

/**
 * Puts a content in the place of a file, which is the old one or the new one at every moment, whatever happens.
 * @param isBase looks, at the last moment, whether the file is still the one to be replaced; throws when it is not
 */
export function replaceFile(path: string, content: Uint8Array, isBase: () => void): void {
  withUnfinished(path, content, (unfinished) => {
    isBase();
    renamePatiently(unfinished, path);
  });
}

/**
 * Makes a new file, whole or not at all.
 * @returns false when something of that name is there; it stays
 */
export function createFile(path: string, content: Uint8Array): boolean {
  let made = false;
  withUnfinished(path, content, (unfinished) => {
    made = linkOrRename(unfinished, path);
  });
  return made;
}

/** Makes a file in a folder and takes it away again: what the operating system says of it is thrown before work whose result will go there. */
export function tryFolder(folder: string): void {
  withUnfinished(join(folder, 'tried'), new Uint8Array(), () => {});
}

/**
 * Moves a file to a free name. A process killed in the middle leaves it under both.
 * @returns false when something of the new name is there; both stay
 */
export function moveFile(from: string, to: string): boolean {
  if (isOnlyCase(from, to)) renamePatiently(from, to);
  else if (!linkOrRename(from, to)) return false;
  else removeOldName(from, to);
  for (const folder of new Set([dirname(from), dirname(to)])) syncFolder(folder);
  return true;
}

function removeOldName(from: string, to: string): void {
  try {
    rmSync(from, { force: true });
  } catch (error) {
    rmSync(to, { force: true });
    throw error;
  }
}

/** What file systems without hard links say. */
const NO_LINKS = new Set(['EPERM', 'ENOTSUP', 'EOPNOTSUPP', 'ENOSYS', 'EMLINK', 'EINVAL']);

/** Gives a file a second name, or, where there are no hard links, a new one: a link never takes another file's place, as a rename would. */
function linkOrRename(from: string, to: string): boolean {
  try {
    linkSync(from, to);
    return true;
  } catch (error) {
    const code = (error as NodeJS.ErrnoException).code ?? '';
    if (code === 'EEXIST') return false;
    if (!NO_LINKS.has(code)) throw error;
  }
  if (isTaken(to)) return false;
  renamePatiently(from, to);
  return true;
}

/** On a file system that takes `A` and `a` for the same name. */
function isOnlyCase(from: string, to: string): boolean {
  if (from === to || from.toLowerCase() !== to.toLowerCase()) return false;
  const [a, b] = [lstatSync(from), lstatSync(to, { throwIfNoEntry: false })];
  return b !== undefined && a.dev === b.dev && a.ino === b.ino;
}

const WINDOWS_TRIES = 10;

/** On Windows a scanner may hold a file for a moment. */
function renamePatiently(from: string, to: string): void {
  for (let left = process.platform === 'win32' ? WINDOWS_TRIES : 1; ; left--) {
    try {
      renameSync(from, to);
      return;
    } catch (error) {
      if (left <= 1 || !['EPERM', 'EACCES', 'EBUSY'].includes((error as NodeJS.ErrnoException).code ?? '')) throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 20);
    }
  }
}

function keepOwnerAndMode(descriptor: number, path: string): void {
  const old = lstatSync(path, { throwIfNoEntry: false });
  // a link's own mode says nothing
  if (old === undefined || !old.isFile()) return;
  fchmodSync(descriptor, old.mode & 0o7777);
  if (process.getuid === undefined || (process.getuid() === old.uid && process.getgid?.() === old.gid)) return;
  try {
    fchownSync(descriptor, old.uid, old.gid);
    fchmodSync(descriptor, old.mode & 0o7777);
  } catch {
    // only an administrator may give files away: it becomes the writer's, as with every other editor
  }
}

/** So that a new name outlives a loss of power. */
function syncFolder(folder: string): void {
  try {
    const descriptor = openSync(folder, 'r');
    try {
      fsyncSync(descriptor);
    } finally {
      closeSync(descriptor);
    }
  } catch {
    // Windows can't, and some network file systems; the file itself is on the disk
  }
}

import { randomBytes } from 'node:crypto';
import {
  closeSync,
  fchmodSync,
  fchownSync,
  fsyncSync,
  linkSync,
  lstatSync,
  mkdirSync,
  openSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join } from 'node:path';
import process from 'node:process';

// everything here is synchronous: signals and other requests are handled before or after a change, never during one

/** Whether anything exists at a path, including a broken link. */
export const isTaken = (path: string): boolean => lstatSync(path, { throwIfNoEntry: false }) !== undefined;

/** The name of an unfinished file; a process that is killed leaves it behind. */
export const UNFINISHED = /^\.gq-edit-[0-9a-f]{16}\.tmp$/;

/**
 * Writes a content completely to a temporary file in the folder of `path`, syncs it to the disk, and calls `place`.
 * @param place moves the temporary file; if it throws, nothing has changed
 * @param how `isLasting`: whether the content must survive a power failure: without syncing, it takes much less time; `mode`: of a
 * new file
 */
function withUnfinished(
  path: string,
  content: Uint8Array,
  place: (unfinished: string) => void,
  { isLasting = true, mode = 0o666 } = {},
): void {
  const unfinished = join(dirname(path), `.gq-edit-${randomBytes(8).toString('hex')}.tmp`);
  try {
    const descriptor = openSync(unfinished, 'wx', mode);
    try {
      keepOwnerAndMode(descriptor, path);
      // writeFileSync writes everything or throws; a single writeSync may write less if the disk is nearly full
      writeFileSync(descriptor, content);
      if (isLasting) fsyncSync(descriptor);
    } finally {
      closeSync(descriptor);
    }
    place(unfinished);
  } finally {
    rmSync(unfinished, { force: true });
  }
  if (isLasting) syncFolder(dirname(path));
}

/**
 * Replaces the content of a file atomically: at every moment, the file is either the old or the new one.
 * @param isBase called right before the replacement; throws if the file has changed and must not be replaced
 */
export function replaceFile(path: string, content: Uint8Array, isBase: () => void): void {
  withUnfinished(path, content, (unfinished) => {
    isBase();
    renamePatiently(unfinished, path);
  });
}

/** The same for a file that can be made anew: after a power failure it may be torn. */
export function replaceSpareFile(path: string, content: Uint8Array): void {
  withUnfinished(path, content, (unfinished) => renamePatiently(unfinished, path), { isLasting: false });
}

/**
 * Creates a new file: completely or not at all.
 * @returns false if the name is taken; nothing changes then
 */
export const createFile = (path: string, content: Uint8Array): boolean => create(path, content, 0o666);

/** The same for a file that only this user can read, at every moment. */
export const createPrivateFile = (path: string, content: Uint8Array): boolean => create(path, content, 0o600);

function create(path: string, content: Uint8Array, mode: number): boolean {
  let made = false;
  const place = (unfinished: string): void => {
    made = linkOrRename(unfinished, path);
  };
  withUnfinished(path, content, place, { mode });
  return made;
}

/** Creates a file in a folder and deletes it again, to throw system errors before the work whose result is written there. */
export function tryFolder(folder: string): void {
  withUnfinished(join(folder, 'tried'), new Uint8Array(), () => {});
}

/**
 * Moves a file to a free name. If the process is killed in the middle, the file has both names.
 * @returns false if the new name is taken; nothing changes then
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

/** Error codes of file systems without hard links. */
const NO_LINKS = new Set(['EPERM', 'ENOTSUP', 'EOPNOTSUPP', 'ENOSYS', 'EMLINK', 'EINVAL']);

/** Gives a file a second name by a hard link, which unlike a rename never replaces a file; renames it if links don't work. */
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

/** Whether two names differ only in case and name the same file, as on file systems that ignore case. */
function isOnlyCase(from: string, to: string): boolean {
  if (from === to || from.toLowerCase() !== to.toLowerCase()) return false;
  const [a, b] = [lstatSync(from), lstatSync(to, { throwIfNoEntry: false })];
  return b !== undefined && a.dev === b.dev && a.ino === b.ino;
}

const WINDOWS_TRIES = 10;

/** Renames a file, with several tries on Windows, where a virus scanner may lock a file for a moment. */
export function renamePatiently(from: string, to: string): void {
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
  // the mode of a link has no meaning
  if (old === undefined || !old.isFile()) return;
  fchmodSync(descriptor, old.mode & 0o7777);
  if (process.getuid === undefined || (process.getuid() === old.uid && process.getgid?.() === old.gid)) return;
  try {
    fchownSync(descriptor, old.uid, old.gid);
    fchmodSync(descriptor, old.mode & 0o7777);
  } catch {
    // only root may change the owner: without it, the file gets the owner of this process, as with other editors
  }
}

/** Syncs a folder to the disk, so that a new name survives a power failure. */
function syncFolder(folder: string): void {
  try {
    const descriptor = openSync(folder, 'r');
    try {
      fsyncSync(descriptor);
    } finally {
      closeSync(descriptor);
    }
  } catch {
    // Windows and some network file systems can't do this; the file itself is already synced
  }
}

/** Characters that are written at once. */
const PIECE = 256 * 1024;

/**
 * Writes a file beside its place, piece by piece, and moves it there at the end. Until then nothing is at its place.
 * All methods throw system errors; `discard` doesn't.
 */
export class LineWriter {
  readonly unfinished: string;
  private readonly descriptor: number;
  private waiting = '';
  private isOpen = true;

  constructor(path: string) {
    this.unfinished = join(dirname(path), `.gq-edit-${randomBytes(8).toString('hex')}.tmp`);
    this.descriptor = openSync(this.unfinished, 'wx', 0o666);
  }

  write(text: string): void {
    this.waiting += text;
    if (this.waiting.length >= PIECE) this.flush();
  }

  /** Syncs and closes the file. */
  end(): void {
    this.flush();
    fsyncSync(this.descriptor);
    this.close();
  }

  /** Removes the unfinished file, if it is still there. */
  discard(): void {
    this.close();
    rmSync(this.unfinished, { force: true });
  }

  private flush(): void {
    // writes everything or throws; a single writeSync may write less if the disk is nearly full
    writeFileSync(this.descriptor, this.waiting);
    this.waiting = '';
  }

  private close(): void {
    if (this.isOpen) closeSync(this.descriptor);
    this.isOpen = false;
  }
}

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

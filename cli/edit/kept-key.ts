import { closeSync, constants, fstatSync, lstatSync, mkdirSync, rmSync, type Stats } from 'node:fs';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { createPrivateFile, makeFolders, openRegularFile, readBeyond, systemReason } from '../io/index.ts';
import { newKey } from './access.ts';
import { forgetOldest, stateFolder } from './user-state.ts';

/** bytes: a key and a line feed */
const LENGTH = 44;
const KEY = /^[\w-]{43}\n$/;

/** The key of a folder. */
export interface KeptKey {
  readonly key: string;
  /** Why the next run will have another key, so that the pages of this one can't come back; null: it will have this one. */
  readonly problem: string | null;
}

/** The file or folder is not what only this user can have made. */
class NotOurs extends Error {}

/** @throws NotOurs */
function checkOwner(path: string, { uid }: Stats): void {
  // Windows has no such numbers: there, the folder is in the profile of the user
  if (process.getuid !== undefined && uid !== process.getuid()) throw new NotOurs(`${path} belongs to another user`);
}

/** Others may have read what this says of, or may put something in its place. */
const isOpen = ({ mode }: Stats, bits: number): boolean => process.getuid !== undefined && (mode & bits) !== 0;

/** The folder of the keys, which only this user can enter. @throws NotOurs, and system errors */
function ownFolder(): string {
  const folder = stateFolder('edit-keys');
  makeFolders(dirname(folder));
  try {
    mkdirSync(folder, { mode: 0o700 });
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'EEXIST') throw error;
  }
  const stats = lstatSync(folder);
  if (!stats.isDirectory()) throw new NotOurs(`${folder} is not a folder`);
  checkOwner(folder, stats);
  if (isOpen(stats, 0o022)) throw new NotOurs(`other users can write into ${folder}`);
  return folder;
}

/** @returns null if there is none, or others could have read it. @throws NotOurs, and system errors */
function readKey(file: string): string | null {
  const stats = lstatSync(file, { throwIfNoEntry: false });
  if (stats === undefined) return null;
  // on Windows, opening would follow a link
  if (!stats.isFile()) throw new NotOurs(`${file} is not a regular file`);
  const descriptor = openRegularFile(file, constants.O_NOFOLLOW ?? 0);
  try {
    const opened = fstatSync(descriptor);
    checkOwner(file, opened);
    const text = Buffer.from(readBeyond(descriptor, LENGTH)).toString('latin1');
    return isOpen(opened, 0o077) || !KEY.test(text) ? null : text.slice(0, -1);
  } finally {
    closeSync(descriptor);
  }
}

/**
 * The key of a folder, the same in each run: it is kept in the user's directory for program state, in a file that only this user
 * can read. A file that is a link, belongs to another user or was open to others is not used.
 * @param folder its id, as in the list of its levels
 */
export function keptKey(folder: string): KeptKey {
  try {
    const file = join(ownFolder(), folder);
    const known = readKey(file);
    if (known !== null) return { key: known, problem: null };
    rmSync(file, { force: true });
    const key = newKey();
    if (createPrivateFile(file, Buffer.from(`${key}\n`))) {
      forgetOldest(dirname(file));
      return { key, problem: null };
    }
    // another run was faster
    return { key: readKey(file) ?? key, problem: null };
  } catch (error) {
    const why = error instanceof NotOurs ? error.message : systemReason(error);
    return { key: newKey(), problem: why };
  }
}

import { createHmac, randomBytes } from 'node:crypto';
import { closeSync, constants, fstatSync, lstatSync, mkdirSync, readdirSync, rmSync, type Stats, statSync } from 'node:fs';
import { homedir } from 'node:os';
import { dirname, isAbsolute, join } from 'node:path';
import process from 'node:process';
import { runMessage, tokenMessage } from '../../schema/index.ts';
import { createPrivateFile, makeFolders, openRegularFile, readBeyond, readRegularFile, replaceFile } from '../io/index.ts';
import { systemReason } from '../terminal/index.ts';

/** What lets pages in. */
export interface Access {
  /** The key of the folder: who has it can derive the token of any run. */
  readonly key: string;
  /** What each request of this run must have. */
  readonly token: string;
  /** Tells a page that has the key which run this is, and that this server has the key, too. */
  run(port: number, challenge: string): { readonly nonce: string; readonly proof: string };
}

/**
 * The access to one run. A page never sends the key, and sends its token to nobody who has not proved to have the key. So a program
 * that listens on the port once `gq edit` has ended learns from the page at most the token of a run that is over.
 */
export function createAccess(key: string): Access {
  const nonce = randomBytes(16).toString('base64url');
  const sign = (message: string): string => createHmac('sha256', key).update(message).digest('base64url');
  return {
    key,
    token: sign(tokenMessage(nonce)),
    run: (port, challenge) => ({ nonce, proof: sign(runMessage(port, challenge, nonce)) }),
  };
}

export const newKey = (): string => randomBytes(32).toString('base64url');

/** bytes: a key and a line feed */
const LENGTH = 44;
const KEY = /^[\w-]{43}\n$/;

/** The key of a folder. */
interface KeptKey {
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

/** bytes; a port number is shorter */
const LONGEST = 16;

/** The user's directory for program state contains a file for each edited folder. */
const fileOf = (folder: string): string => join(stateFolder('edit-ports'), folder);

/**
 * The port on which a folder was last edited; null if it is not known.
 * @param folder its id, as in the list of its levels
 */
export function lastPort(folder: string): number | null {
  try {
    const text = Buffer.from(readRegularFile(fileOf(folder), LONGEST)).toString();
    const port = Number(text);
    return /^\d{1,5}\n$/.test(text) && port > 0 && port < 65536 ? port : null;
  } catch {
    return null;
  }
}

/** Remembers the port for the next run, if it can be stored. */
export function keepPort(folder: string, port: number): void {
  try {
    const file = fileOf(folder);
    makeFolders(dirname(file));
    replaceFile(file, Buffer.from(`${port}\n`), () => {});
    forgetOldest(dirname(file));
  } catch {
    // no home directory, or not writable: the next run uses the usual port
  }
}

/** The largest number of files of one kind. */
const MOST = 1000;

/** The folder of one kind of files in the user's directory for program state. */
function stateFolder(kind: string): string {
  const { XDG_STATE_HOME, LOCALAPPDATA } = process.env;
  const own = process.platform === 'win32' ? LOCALAPPDATA : XDG_STATE_HOME;
  const usual: Record<string, string> = { win32: 'AppData/Local', darwin: 'Library/Application Support' };
  const state = own !== undefined && isAbsolute(own) ? own : join(homedir(), usual[process.platform] ?? '.local/state');
  return join(state, 'gravity-quest-toolkit', kind);
}

/** Removes the oldest files where there are very many. */
function forgetOldest(folder: string): void {
  const names = readdirSync(folder);
  if (names.length <= MOST) return;
  const aged = names.map((name) => ({ path: join(folder, name), time: statSync(join(folder, name)).mtimeMs }));
  for (const { path } of aged.sort((a, b) => a.time - b.time).slice(0, names.length - MOST)) rmSync(path, { force: true });
}

import { accessSync, constants, lstatSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { MAX_FILE_SIZE, PACK_NAME, type PackOnDisk, readPack } from '../../schema/index.ts';
import { createFile, readRegularFile, replaceFile, whyNotWritable } from '../io/index.ts';
import { systemReason } from '../terminal/index.ts';
import { type Base, etagOf } from './read-entry.ts';
import { Refusal, refuseWayOut } from './refusal.ts';

// if a link has replaced the file since it was looked at, it is not followed; Windows has no such flag
const NO_FOLLOW = constants.O_NOFOLLOW ?? 0;

/**
 * The `pack.json` of a folder as it is now; null if there is none. Never throws.
 * @param root the folder's real path
 * @param shown the folder as the user named it
 */
export function readPackOnDisk(root: string, shown: string): PackOnDisk | null {
  const path = join(root, PACK_NAME);
  const file = join(shown, PACK_NAME);
  const stats = lstatSync(path, { throwIfNoEntry: false });
  // a folder of that name says nothing about an order
  if (stats === undefined || stats.isDirectory()) return null;
  const unreadable = (why: string): PackOnDisk => ({ file, etag: null, text: null, readOnly: why });
  if (stats.isSymbolicLink()) return unreadable("it is a symbolic link, which the editor doesn't follow");
  try {
    const bytes = readRegularFile(path, MAX_FILE_SIZE, NO_FOLLOW);
    if (bytes.length > MAX_FILE_SIZE) return unreadable('it is larger than 8 MiB');
    return { file, etag: etagOf(bytes), text: Buffer.from(bytes).toString(), readOnly: whyReadOnly(root, path) };
  } catch (error) {
    return unreadable(`it can't be read: ${systemReason(error)}`);
  }
}

function whyReadOnly(root: string, path: string): string | null {
  const why = whyNotWritable(path);
  if (why !== null) return `the file can't be written: ${why}`;
  try {
    accessSync(root, constants.W_OK);
    return null;
  } catch (error) {
    return `its folder can't be written: ${systemReason(error)}`;
  }
}

/** Writes the `pack.json` of a folder, or removes it. @throws Refusal; nothing has changed then */
export function writePackOnDisk(root: string, shown: string, text: string | null, base: Base): void {
  const path = join(root, PACK_NAME);
  const content = text === null ? null : Buffer.from(text);
  if (content !== null) refuseInvalid(content);
  refuseWayOut(path);
  const now = readPackOnDisk(root, shown);
  // a repeated request: the answer to the first one was lost
  if (content === null ? now === null : now?.etag === etagOf(content)) return;
  const onBase = (): void => refuseOtherBase(readPackOnDisk(root, shown), join(shown, PACK_NAME), base);
  onBase();
  if (now !== null && now.readOnly !== null)
    throw new Refusal('not-writable', `${now.file}: ${now.readOnly}`, 'Allow writing to it, then do it again.');
  if (content === null) rmSync(path);
  else if (base !== 'no-file') replaceFile(path, content, onBase);
  else if (!createFile(path, content)) throw changedOnDisk(join(shown, PACK_NAME));
}

function refuseOtherBase(now: PackOnDisk | null, file: string, base: Base): void {
  const isSame = base === 'no-file' ? now === null : now !== null && now.etag === base.etag;
  if (!isSame) throw changedOnDisk(file);
}

const changedOnDisk = (file: string): Refusal =>
  new Refusal('conflict', `${file} has changed on the disk`, 'It is read again; then do it once more.');

function refuseInvalid(content: Uint8Array): void {
  const read = readPack(content);
  if (read.ok) return;
  const { problems } = read;
  const message = `this is not a valid pack: ${problems[0].message}`;
  throw new Refusal('invalid-pack', message, 'The file is unchanged.', { problems });
}

import { lstatSync, readlinkSync, realpathSync, statSync, writeFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { replaceFile } from './disk.ts';
import { Failure, systemReason } from './failure.ts';
import { uncut } from './signals.ts';
import { whyNotWritable } from './writable.ts';

/** Where a path leads when links are followed, also to where nothing is yet. */
function followed(path: string): string {
  const stats = lstatSync(path, { throwIfNoEntry: false });
  if (stats === undefined) return path;
  try {
    return realpathSync(path);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'ENOENT' || !stats.isSymbolicLink()) throw error;
    // a link beside it is followed in turn; the system has found no ring
    return followed(resolve(realpathSync(dirname(path)), readlinkSync(path)));
  }
}

/**
 * Writes a file whole or not at all, and keeps the mode of one that exists. A device or pipe is written to as it is.
 * @throws Failure saying why it can't be written
 */
export async function writeWhole(path: string, content: string | Uint8Array): Promise<void> {
  const bytes = typeof content === 'string' ? Buffer.from(content) : content;
  const target = tryTo(path, () => followed(path));
  const stats = statSync(target, { throwIfNoEntry: false });
  // its reader may let us wait, and a signal is to end that
  if (stats !== undefined && !stats.isFile()) return tryTo(path, () => writeFileSync(target, bytes));
  await uncut(() => tryTo(path, () => replace(target, bytes)));
}

/** The same within other work that no signal cuts; only for a regular file, or where none is. */
export function replaceRegular(path: string, content: Uint8Array): void {
  tryTo(path, () => {
    const target = followed(path);
    if (statSync(target, { throwIfNoEntry: false })?.isFile() === false) throw new Error('it is not a regular file');
    replace(target, content);
  });
}

function replace(target: string, bytes: Uint8Array): void {
  const why = lstatSync(target, { throwIfNoEntry: false }) === undefined ? null : whyNotWritable(target);
  if (why !== null) throw new Error(why);
  replaceFile(target, bytes, () => {});
}

function tryTo<T>(path: string, work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
}

import { closeSync, openSync, realpathSync, type Stats, statSync } from 'node:fs';
import { MAX_FILE_SIZE } from '../schema/index.ts';
import { Failure, systemReason } from './failure.ts';
import { NotAFile, readBeyond, readRegularFile } from './regular-file.ts';
import { namedPath } from './shown-path.ts';
import { siblingHint } from './sibling-hint.ts';

/**
 * A file's bytes; of one larger than `MAX_FILE_SIZE` only the first so many and a few more, which readers refuse. A pipe that the shell
 * has made (`<(command)`, /dev/stdin) is read to its end, however long that takes; one that has a name is refused, since nobody may ever write to it.
 * @throws Failure saying why it can't be read
 */
export function readBytes(path: string): Uint8Array {
  try {
    return isStream(path, statSync(path)) ? readStream(path) : readRegularFile(path, MAX_FILE_SIZE);
  } catch (error) {
    throw new Failure(`${namedPath(path)}: can't be read: ${systemReason(error)}${hintFor(path, error)}`);
  }
}

function hintFor(path: string, error: unknown): string {
  const code = (error as NodeJS.ErrnoException).code;
  // what a folder lists so can't be asked for: the bytes of its name are lost
  if (code === 'ENOENT') return path.includes('\ufffd') ? '; its name is not UTF-8: rename it' : siblingHint(path);
  if (error instanceof NotAFile) return code === 'EISDIR' ? '; expected a file' : '; expected a file, or /dev/stdin for a pipe';
  return code === 'ENXIO' ? ' (is it a socket?); expected a file' : '';
}

/** Whether reading may wait for somebody: a device, a pipe without a name of its own, or one that was opened for us. */
export function isStream(path: string, stats: Stats): boolean {
  return stats.isCharacterDevice() || (stats.isFIFO() && (path.startsWith('/dev/') || !hasName(path)));
}

/** What /dev/fd/63 leads to is found in no folder. */
function hasName(path: string): boolean {
  try {
    return !realpathSync.native(path).startsWith('/dev/');
  } catch {
    return false;
  }
}

function readStream(path: string): Uint8Array {
  const descriptor = openSync(path, 'r');
  try {
    return readBeyond(descriptor, MAX_FILE_SIZE);
  } finally {
    closeSync(descriptor);
  }
}

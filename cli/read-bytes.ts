import { closeSync, openSync, realpathSync, type Stats, statSync } from 'node:fs';
import { MAX_FILE_SIZE } from '../schema/basics/index.ts';
import { Failure, systemReason } from './failure.ts';
import { entryName, readEntry } from './packs/index.ts';
import { NotAFile, readBeyond, readRegularFile } from './regular-file.ts';
import { namedPath } from './shown-path.ts';
import { siblingHint } from './sibling-hint.ts';

/**
 * Reads the bytes of a file, or of an entry of a pack (`levels.tar#a.level.json`, `levels.ndjson#12`); of one larger than `MAX_FILE_SIZE` only slightly more than that, which readers then refuse.
 * A pipe of the shell (`<(command)`, /dev/stdin) is read to its end, however long that takes; a named pipe is refused, because
 * there may never be a writer.
 * @throws Failure with the reason if it can't be read
 */
export function readBytes(path: string): Uint8Array {
  try {
    const entry = entryName(path);
    const stats = statSync(path, { throwIfNoEntry: entry === null });
    if (stats === undefined) return readEntry(entry!.pack, entry!.label);
    return isStream(path, stats) ? readStream(path) : readRegularFile(path, MAX_FILE_SIZE);
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(`${namedPath(path)}: can't be read: ${systemReason(error)}${hintFor(path, error)}`);
  }
}

function hintFor(path: string, error: unknown): string {
  const code = (error as NodeJS.ErrnoException).code;
  // a listed name that is not UTF-8 can't be opened: its bytes are lost in the conversion
  if (code === 'ENOENT') return path.includes('\ufffd') ? '; its name is not UTF-8: rename it' : siblingHint(path);
  if (error instanceof NotAFile) return code === 'EISDIR' ? '; expected a file' : '; expected a file, or /dev/stdin for a pipe';
  return code === 'ENXIO' ? ' (is it a socket?); expected a file' : '';
}

/** Whether reading may block: a character device, an unnamed pipe, or a pipe that the shell has opened under /dev. */
export function isStream(path: string, stats: Stats): boolean {
  return stats.isCharacterDevice() || (stats.isFIFO() && (path.startsWith('/dev/') || !hasName(path)));
}

/** Whether a path leads to a file in a folder; /dev/fd/63 does not. */
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

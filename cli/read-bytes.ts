import { closeSync, openSync, readSync } from 'node:fs';
import { MAX_FILE_SIZE } from '../schema/index.ts';
import { Failure, systemReason } from './failure.ts';
import { namedPath } from './shown-path.ts';
import { siblingHint } from './sibling-hint.ts';

/**
 * A file's bytes; of one larger than `MAX_FILE_SIZE` only the first so many and a few more, which readers refuse.
 * @throws Failure saying why it can't be read
 */
export function readBytes(path: string): Uint8Array {
  let descriptor: number | null = null;
  try {
    descriptor = openSync(path, 'r');
    return readBeyond(descriptor, MAX_FILE_SIZE);
  } catch (error) {
    const code = (error as NodeJS.ErrnoException).code;
    const hint = code === 'ENOENT' ? siblingHint(path) : code === 'EISDIR' ? '; expected a file' : '';
    throw new Failure(`${namedPath(path)}: can't be read: ${systemReason(error)}${hint}`);
  } finally {
    if (descriptor !== null) closeSync(descriptor);
  }
}

/** Reads to the end, or a bit more than `limit` bytes. In pieces: a pipe has no size to ask for, and a device may have no end. */
function readBeyond(descriptor: number, limit: number): Uint8Array {
  const pieces: Uint8Array[] = [];
  let total = 0;
  // most levels fit into the first piece
  let piece = Buffer.allocUnsafe(16 * 1024);
  let filled = 0;
  for (;;) {
    const count = readSync(descriptor, piece, { offset: filled });
    filled += count;
    total += count;
    const atEnd = count === 0 || total > limit;
    if (atEnd || filled === piece.length) pieces.push(piece.subarray(0, filled));
    if (atEnd) return pieces.length === 1 ? pieces[0] : Buffer.concat(pieces, total);
    if (filled < piece.length) continue;
    piece = Buffer.allocUnsafe(Math.min(2 * piece.length, 4 * 1024 * 1024));
    filled = 0;
  }
}

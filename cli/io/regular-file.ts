import { closeSync, constants, fstatSync, openSync, readSync } from 'node:fs';
import { pointerFile } from '../../schema/json/index.ts';
import { Failure, namedPath } from '../terminal/index.ts';

// non-blocking, as opening a pipe must not wait for its writer. The type is checked after opening, because the path may lead to
// another file a moment later. Windows has no such flag.
const AT_ONCE = constants.O_RDONLY | (constants.O_NONBLOCK ?? 0);

/** Thrown if a path leads to something other than a regular file. */
export class NotAFile extends Error {
  override readonly name = 'NotAFile';
  /** EISDIR for a folder, else null. */
  readonly code: string | null;

  constructor(what: string, code: string | null = null) {
    super(`it is ${what}, not a regular file`);
    this.code = code;
  }
}

/**
 * Opens a regular file for reading. Never blocks, whatever the path leads to.
 * @param flags for opening, such as `constants.O_NOFOLLOW`
 * @throws NotAFile, and system errors
 */
export function openRegularFile(path: string, flags = 0): number {
  const descriptor = openSync(path, AT_ONCE | flags);
  try {
    const stats = fstatSync(descriptor);
    if (stats.isDirectory()) throw new NotAFile('a folder', 'EISDIR');
    if (stats.isFIFO()) throw new NotAFile('a named pipe');
    if (!stats.isFile()) throw new NotAFile('a device');
    return descriptor;
  } catch (error) {
    closeSync(descriptor);
    throw error;
  }
}

/**
 * Reads the bytes of a regular file; of one longer than `limit` only slightly more than that. Never blocks and needs no more
 * memory than that, whatever the path leads to.
 * @param flags for opening, such as `constants.O_NOFOLLOW`
 * @throws NotAFile, and system errors
 */
export function readRegularFile(path: string, limit: number, flags = 0): Uint8Array {
  const descriptor = openRegularFile(path, flags);
  try {
    return readBeyond(descriptor, limit);
  } finally {
    closeSync(descriptor);
  }
}

/** Reads to the end, or slightly more than `limit` bytes; in pieces, as a pipe has no size and a device may have no end. */
export function readBeyond(descriptor: number, limit: number): Uint8Array {
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

/**
 * Refuses a file that only says where its content is, as Git LFS leaves it.
 * @param expected what the file should be, in words
 * @param head its bytes, or the first of them if it is longer than a kilobyte
 * @throws Failure that says how to get the content
 */
export function refusePointer(path: string, expected: string, head: Uint8Array): void {
  const pointer = pointerFile(head);
  if (pointer === null) return;
  throw new Failure(`${namedPath(path)}: expected ${expected}, found ${pointer.found}. ${pointer.hint}`);
}

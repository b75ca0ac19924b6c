import { closeSync, constants, fstatSync, openSync, readSync } from 'node:fs';

// a pipe is not waited for: whether it is one is asked of what was opened, since a path may be another thing a moment later. Windows knows no such flag
const AT_ONCE = constants.O_RDONLY | (constants.O_NONBLOCK ?? 0);

/** What was found where a regular file was expected. */
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
 * The bytes of a regular file; of one that has more than `limit` only the first so many and a few more. Never waits for anybody, and takes
 * no more memory than that, whatever stands at the path.
 * @param flags besides reading: `constants.O_NOFOLLOW`
 * @throws NotAFile, and what the operating system says
 */
export function readRegularFile(path: string, limit: number, flags = 0): Uint8Array {
  const descriptor = openSync(path, AT_ONCE | flags);
  try {
    const stats = fstatSync(descriptor);
    if (stats.isDirectory()) throw new NotAFile('a folder', 'EISDIR');
    if (stats.isFIFO()) throw new NotAFile('a named pipe');
    if (!stats.isFile()) throw new NotAFile('a device');
    return readBeyond(descriptor, limit);
  } finally {
    closeSync(descriptor);
  }
}

/** Reads to the end, or a bit more than `limit` bytes. In pieces: a pipe has no size to ask for, and a device may have no end. */
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

import { fstatSync, readSync } from 'node:fs';
import process from 'node:process';
import { MAX_FILE_SIZE } from '../schema/basics/index.ts';
import { Failure, systemReason } from './failure.ts';

/** The path that stands for standard input. */
export const STDIN = '-';

/** The name of a level from standard input in reports, unless it is given. */
export const STDIN_NAME = '<stdin>';

/**
 * The name of the level in standard input; null if the paths name files.
 * @throws Failure if there are other paths beside it, or a name for it without it
 */
export function stdinName(paths: readonly string[], name: string | undefined): string | null {
  if (!paths.includes(STDIN)) {
    if (name === undefined) return null;
    throw new Failure('--stdin-path names the level from standard input: expected the path - with it');
  }
  if (paths.length === 1) return name ?? STDIN_NAME;
  throw new Failure(
    'the path - reads one level from standard input: expected no other path with it (./- is a file of that name)',
  );
}

/**
 * Reads standard input to its end; of more than `MAX_FILE_SIZE` bytes only slightly more, which readers then refuse.
 * @throws Failure if it is a terminal or can't be read
 */
export function readStdin(command: string): Uint8Array {
  if (process.stdin.isTTY) {
    throw new Failure(
      `standard input is a terminal: expected a level from a file or a pipe, as in gq ${command} - < a.level.json`,
    );
  }
  try {
    if (fstatSync(0).isDirectory()) throw new Failure('standard input is a directory: expected a level');
    return readToEnd();
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(`standard input can't be read: ${systemReason(error)}`);
  }
}

function readToEnd(): Uint8Array {
  const pieces: Uint8Array[] = [];
  for (let total = 0; total <= MAX_FILE_SIZE; ) {
    const piece = Buffer.allocUnsafe(64 * 1024);
    const count = readPatiently(piece);
    if (count === 0) break;
    pieces.push(piece.subarray(0, count));
    total += count;
  }
  return Buffer.concat(pieces);
}

function readPatiently(piece: Uint8Array): number {
  for (;;) {
    try {
      return readSync(0, piece);
    } catch (error) {
      const code = (error as NodeJS.ErrnoException).code;
      // the end of a pipe on Windows
      if (code === 'EOF') return 0;
      if (code !== 'EAGAIN') throw error;
      // the writer has made the pipe non-blocking, and has nothing yet
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 5);
    }
  }
}

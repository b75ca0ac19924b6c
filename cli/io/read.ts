import {
  closeSync,
  existsSync,
  fstatSync,
  lstatSync,
  openSync,
  readdirSync,
  readlinkSync,
  readSync,
  realpathSync,
  type Stats,
  statSync,
} from 'node:fs';
import { basename, dirname } from 'node:path';
import process from 'node:process';
import { closestName, MAX_FILE_SIZE } from '../../schema/basics/index.ts';
import { Failure, namedPath, systemReason } from '../terminal/index.ts';
import { entryName, readEntry } from './packs/index.ts';
import { NotAFile, readBeyond, readRegularFile } from './regular-file.ts';

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

/** The part of a name that tells level files apart: `.level.json` at the end of both would make any two names look close. */
const stemOf = (name: string): string => name.replace(/(?:\.level)?\.[^.]+$/, '');

/**
 * For a path at which there is nothing: where a symbolic link at it or above it points to, or ` (did you mean X?)` when a name beside
 * it is close, else nothing.
 */
export function siblingHint(path: string): string {
  try {
    const broken = brokenLinkOn(path);
    if (broken !== null)
      return `; ${broken === path ? 'it' : broken} is a symbolic link to ${readlinkSync(broken)}, which leads nowhere`;
    const names = readdirSync(dirname(path));
    const stem = closestName(stemOf(basename(path)), names.map(stemOf));
    const same = names.filter((name) => stemOf(name) === stem);
    const best = closestName(basename(path), same) ?? same.find((name) => name.endsWith('.level.json')) ?? same[0];
    return best === undefined ? '' : ` (did you mean ${best}?)`;
  } catch {
    return '';
  }
}

/** The symbolic link on the way to a path that leads nowhere: the path itself or a folder of it; null if there is none. */
function brokenLinkOn(path: string): string | null {
  for (let at = path; ; at = dirname(at)) {
    const stats = lstatSync(at, { throwIfNoEntry: false });
    if (stats?.isSymbolicLink() === true && !existsSync(at)) return at;
    if (stats !== undefined || dirname(at) === at) return null;
  }
}

import { createReadStream, readSync } from 'node:fs';
import { pipeline, type Transform } from 'node:stream';
import * as zlib from 'node:zlib';
import { Failure, systemReason } from '../failure.ts';
import { refusePointer } from '../pointer.ts';
import { NotAFile, openRegularFile } from '../regular-file.ts';
import { namedPath } from '../shown-path.ts';
import type { PackFormat } from './formats.ts';

/** Bytes that are read at a time. */
const PIECE = 256 * 1024;

/** Bytes in which a pack may turn out to be a pointer to one; a pointer has fewer. */
const HEAD = 2048;

/** Node has zstd from 22.15 on. */
const { createZstdDecompress } = zlib as { createZstdDecompress?: (options: object) => Transform };

/**
 * The bytes of a pack, decompressed.
 * @throws Failure if it can't be read or unpacked
 */
export async function* openPack(path: string, { compression }: PackFormat): AsyncGenerator<Buffer> {
  // a named pipe may never have a writer, and a set is read more than once
  const file = createReadStream(path, { fd: opened(path), highWaterMark: PIECE });
  let unpacked: AsyncIterable<Buffer> = file;
  if (compression !== null) {
    const unpack = compression === 'gzip' ? zlib.createGunzip({ chunkSize: PIECE }) : zstd(path);
    // errors reach the reader below
    unpacked = pipeline(file, unpack, () => {});
  }
  try {
    yield* unpacked;
  } catch (error) {
    if (error instanceof Failure) throw error;
    const isSystem = typeof (error as NodeJS.ErrnoException).syscall === 'string';
    const what = compression === null || isSystem ? "can't be read" : `can't be unpacked (${compression})`;
    const why = isSystem ? systemReason(error) : `${(error as Error).message}; it may be cut off or damaged`;
    throw new Failure(`${namedPath(path)}: ${what}: ${why}`);
  } finally {
    file.destroy();
  }
}

function opened(path: string): number {
  try {
    const descriptor = openRegularFile(path);
    const head = Buffer.alloc(HEAD);
    // at a place of its own: the stream still begins with the first byte
    refusePointer(path, 'a pack', head.subarray(0, readSync(descriptor, head, 0, HEAD, 0)));
    return descriptor;
  } catch (error) {
    if (error instanceof Failure) throw error;
    const expected = error instanceof NotAFile ? '; expected a file' : '';
    throw new Failure(`${namedPath(path)}: can't be read: ${systemReason(error)}${expected}`);
  }
}

function zstd(path: string): Transform {
  if (createZstdDecompress !== undefined) return createZstdDecompress({ chunkSize: PIECE });
  throw new Failure(
    `${namedPath(path)}: Node ${process.versions.node} can't unpack zstd: expected Node 22.15 or newer, or a pack as .gz`,
  );
}

import { createReadStream, readSync } from 'node:fs';
import { pipeline, type Readable, type Transform } from 'node:stream';
import * as zlib from 'node:zlib';
import { Failure, namedPath, systemReason } from '../messages.ts';
import { NotAFile, openRegularFile, refusePointer } from '../regular-file.ts';
import type { PackFormat } from './formats.ts';
import { ZstdFrame } from './zstd-frame.ts';

/** Bytes that are read at a time. */
const PIECE = 256 * 1024;

/** Bytes in which a pack may turn out to be a pointer to one; a pointer has fewer. */
const HEAD = 2048;

/** Node has zstd from 22.15 on. */
const { createZstdDecompress } = zlib as { createZstdDecompress?: (options: object) => Transform };

/**
 * The bytes of a pack, decompressed.
 * @throws Failure if it can't be read or unpacked, or if it is cut off
 */
export async function* openPack(path: string, { compression }: PackFormat): AsyncGenerator<Buffer> {
  // a named pipe may never have a writer, and a set is read more than once
  const file = createReadStream(path, { fd: opened(path), highWaterMark: PIECE });
  try {
    if (compression === null) yield* file;
    else yield* compression === 'gzip' ? gunzipped(path, file) : unzstd(path, file);
  } catch (error) {
    if (error instanceof Failure) throw error;
    const isSystem = typeof (error as NodeJS.ErrnoException).syscall === 'string';
    if (compression !== null && !isSystem) throw damaged(path, compression, error as Error);
    throw new Failure(`${namedPath(path)}: can't be read: ${systemReason(error)}`);
  } finally {
    file.destroy();
  }
}

/** What is said of a pack that can't be unpacked. */
export const damaged = (path: string, compression: 'gzip' | 'zstd', { message }: Error): Failure =>
  new Failure(`${namedPath(path)}: can't be unpacked (${compression}): ${message}; it may be cut off or damaged`);

async function* gunzipped(path: string, file: Readable): AsyncGenerator<Buffer> {
  const unpack = zlib.createGunzip({ chunkSize: PIECE });
  // errors reach the reader
  yield* pipeline(file, unpack, () => {});
  // zeros may follow, which tapes add; gunzip leaves out what comes after them
  for await (const piece of createReadStream(path, { fd: opened(path), start: unpack.bytesWritten }))
    if ((piece as Buffer).some((byte) => byte !== 0)) throw new Error(AFTER_ZEROS);
}

/** What is wrong where gunzip stops reading. */
export const AFTER_ZEROS = 'there is more after the zeros at its end';

/** Each frame has a stream of its own, because Node's ends after the first one. */
async function* unzstd(path: string, file: Readable): AsyncGenerator<Buffer> {
  const unpack = createZstdDecompress;
  if (unpack === undefined) throw noZstd(path);
  const pieces = file[Symbol.asyncIterator]() as AsyncIterator<Buffer>;
  let rest: Buffer = Buffer.alloc(0);
  const read = async (): Promise<boolean> => {
    while (rest.length === 0) {
      const { value, done } = await pieces.next();
      if (done) return false;
      rest = value;
    }
    return true;
  };
  async function* frame(): AsyncGenerator<Buffer> {
    const one = new ZstdFrame();
    while (!one.isWhole) {
      if (!(await read())) throw new Error(UNEXPECTED_END);
      const count = one.take(rest);
      yield rest.subarray(0, count);
      rest = rest.subarray(count);
    }
  }
  while (await read()) yield* pipeline(frame, unpack({ chunkSize: PIECE }), () => {});
}

/** What Node says of gzip. */
export const UNEXPECTED_END = 'unexpected end of file';

export const noZstd = (path: string): Failure =>
  new Failure(
    `${namedPath(path)}: Node ${process.versions.node} can't unpack zstd: expected Node 22.15 or newer, or a pack as .gz`,
  );

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

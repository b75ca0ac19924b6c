import { createReadStream, readSync } from 'node:fs';
import { pipeline, type Readable, type Transform } from 'node:stream';
import * as zlib from 'node:zlib';
import { Failure, namedPath, systemReason } from '../../terminal/index.ts';
import { NotAFile, openRegularFile, refusePointer } from '../regular-file.ts';
import type { PackFormat } from './batch.ts';

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

/** The number with which a frame begins, and the last of the 16 with which one begins that readers skip. */
const FRAME = 0xfd2fb528;
const SKIPPED = 0x184d2a50;

/** Bytes of the length of the content and of the number of a dictionary, by their flags. */
const LENGTHS = [0, 2, 4, 8] as const;
const DICTIONARIES = [0, 1, 2, 4] as const;

/** A kind of block that is one byte, repeated. */
const REPEATED = 1;

/** Bytes that come next: `isKept`, if they decide on what follows. */
interface Next {
  readonly length: number;
  readonly isKept: boolean;
}

const kept = (length: number): Next => ({ length, isKept: true });
const passed = (length: number): Next => ({ length, isKept: false });

/** The parts of a frame, as RFC 8878 has them. Each yield gets the bytes that it has asked for, if they are kept. */
function* parts(): Generator<Next, void, Buffer> {
  const magic = (yield kept(4)).readUInt32LE();
  if ((magic & ~0xf) >>> 0 === SKIPPED) {
    yield passed((yield kept(4)).readUInt32LE());
    return;
  }
  if (magic !== FRAME) throw new Error('unknown frame descriptor');
  const descriptor = (yield kept(1))[0];
  const isSingle = (descriptor & 0x20) !== 0;
  const length = descriptor >>> 6 === 0 && isSingle ? 1 : LENGTHS[descriptor >>> 6];
  yield passed((isSingle ? 0 : 1) + DICTIONARIES[descriptor & 3] + length);
  for (let isLast = false; !isLast; ) {
    const block = (yield kept(3)).readUIntLE(0, 3);
    isLast = (block & 1) === 1;
    yield passed(((block >>> 1) & 3) === REPEATED ? 1 : block >>> 3);
  }
  if ((descriptor & 4) !== 0) yield passed(4);
}

/**
 * Says where a zstd frame ends, without unpacking it. Node unpacks the first frame of a file and leaves out others, and
 * some of its versions take a frame that is cut off for a whole one (seen with 22.15).
 */
export class ZstdFrame {
  private readonly parts = parts();
  private next: IteratorResult<Next, void> = this.parts.next();
  private left = 4;
  private bytes: number[] = [];

  get isWhole(): boolean {
    return this.next.done === true;
  }

  /** @returns how many bytes of the piece belong to the frame. @throws Error if it is none */
  take(piece: Uint8Array): number {
    let at = 0;
    while (!this.isWhole && (at < piece.length || this.left === 0)) {
      const count = Math.min(this.left, piece.length - at);
      if ((this.next.value as Next).isKept) this.bytes.push(...piece.subarray(at, at + count));
      at += count;
      this.left -= count;
      if (this.left > 0) break;
      this.next = this.parts.next(Buffer.from(this.bytes));
      this.bytes = [];
      this.left = this.isWhole ? 0 : (this.next.value as Next).length;
    }
    return at;
  }
}

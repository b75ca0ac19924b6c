import * as zlib from 'node:zlib';
import { Failure, namedPath } from '../../terminal/index.ts';
import { readRegularFile, refusePointer } from '../regular-file.ts';
import { type Batch, type BatchLimits, BatchMaker, type Contents, MOST_OF_ENTRY, packFormat, sizeOf, unwrap } from './batch.ts';
import { AFTER_ZEROS, damaged, noZstd, openPack, UNEXPECTED_END, ZstdFrame } from './open-pack.ts';
import { TarArchive } from './tar-archive.ts';

/** Which files of an archive count. */
const COUNTS: Readonly<Record<Contents, RegExp>> = { levels: /\.level\.json$/, plays: /\.gqr$/ };

const WHAT: Readonly<Record<Contents, string>> = {
  levels: 'level: expected a level a line',
  plays: 'play: expected a play a line',
};
const FILES: Readonly<Record<Contents, string>> = { levels: '*.level.json', plays: '*.gqr' };

/**
 * Reads a set in the order of its paths, a batch at a time, so that it needs no more memory than a few batches.
 * @param paths files and packs
 * @throws Failure if a pack can't be read, is damaged, or contains nothing
 */
export async function* readSet(paths: readonly string[], contents: Contents, limits: BatchLimits): AsyncGenerator<Batch> {
  let first = 0;
  for (let i = 0; i < paths.length; ) {
    const format = packFormat(paths[i]);
    if (format === null) {
      const files: string[] = [];
      while (i < paths.length && files.length < limits.entries && packFormat(paths[i]) === null) files.push(paths[i++]);
      yield { first, source: { files } };
      first += files.length;
      continue;
    }
    const path = paths[i++];
    const before = first;
    const maker = new BatchMaker(path, format.kind, first, limits);
    const stream = openPack(path, format);
    const isCounted = (name: string): boolean => COUNTS[contents].test(name);
    // loaded only for archives, as it takes time
    const batches =
      format.kind === 'tar'
        ? (await import('./tar-archive.ts')).readTar(path, stream, maker, isCounted)
        : readLines(stream, maker);
    for await (const batch of batches) {
      first += sizeOf(batch);
      yield batch;
    }
    if (first > before) continue;
    const expected = format.kind === 'tar' ? `${contents.slice(0, -1)}: expected ${FILES[contents]} in it` : WHAT[contents];
    throw new Failure(`${namedPath(path)}: it contains no ${expected}`);
  }
}

const NEWLINE = 0x0a;

/** Whether a line has only white space. */
const isBlank = (pieces: readonly Uint8Array[]): boolean =>
  pieces.every((piece) => piece.length < 1024 && piece.every((byte) => byte === 0x20 || byte === 0x09 || byte === 0x0d));

/** The lines of a pack. Lines of white space alone don't count. */
async function* readLines(stream: AsyncIterable<Buffer>, maker: BatchMaker): AsyncGenerator<Batch> {
  let number = 0;
  let length = 0;
  let pieces: Uint8Array[] = [];
  const take = (piece: Uint8Array): void => {
    if (piece.length === 0) return;
    if (length < MOST_OF_ENTRY) pieces.push(piece.subarray(0, MOST_OF_ENTRY - length));
    length += piece.length;
  };
  const endLine = (): void => {
    number++;
    if (!isBlank(pieces)) maker.add(number, pieces);
    pieces = [];
    length = 0;
  };
  for await (const piece of stream) {
    let from = 0;
    for (let at = piece.indexOf(NEWLINE); at >= 0; at = piece.indexOf(NEWLINE, from)) {
      take(piece.subarray(from, at));
      endLine();
      from = at + 1;
    }
    // a stream may use the memory of a piece again
    take(Buffer.from(piece.subarray(from)));
    yield* maker.take();
  }
  if (length > 0) endLine();
  yield* maker.take();
}

/** Bytes of a pack from which a single entry is taken at most, packed and unpacked. */
const MOST_UNPACKED = 1024 * 1024 * 1024;

const ENTRY = /^(.*?\.(?:ndjson|tar|tgz)(?:\.(?:gz|zst))?)#(.+)$/is;

/** The pack and the label in the name of an entry of a pack; null if a path is no such name. */
export function entryName(path: string): { readonly pack: string; readonly label: string } | null {
  const found = ENTRY.exec(path);
  return found === null || packFormat(found[1]) === null ? null : { pack: found[1], label: found[2] };
}

/**
 * Reads one entry of a pack, by the name that it has in reports.
 * @throws Failure if there is none; system errors of the pack
 */
export function readEntry(pack: string, label: string): Uint8Array {
  const packed = readRegularFile(pack, MOST_UNPACKED);
  if (packed.length > MOST_UNPACKED)
    throw new Failure(`${namedPath(pack)}: it is too large to take out a single entry: unpack it`);
  refusePointer(pack, 'a pack', packed);
  const format = packFormat(pack)!;
  const bytes = format.compression === null ? packed : unpacked(pack, packed, format.compression);
  const found = format.kind === 'tar' ? filesOf(pack, bytes, label) : linesOf(bytes, label);
  if (found.length > 1) {
    const where = format.kind === 'tar' ? `${found.length} files` : `lines ${found.map(({ line }) => line).join(', ')}`;
    throw new Failure(
      `${namedPath(`${pack}#${label}`)}: expected one level of that name, found ${where}: give each a name of its own`,
    );
  }
  if (found.length > 0) return found[0].content;
  const what = format.kind === 'tar' ? 'file of that name' : 'such line or id';
  throw new Failure(`${namedPath(`${pack}#${label}`)}: the pack has no ${what}`);
}

function unpacked(pack: string, bytes: Uint8Array, compression: 'gzip' | 'zstd'): Uint8Array {
  try {
    return compression === 'gzip' ? gunzipped(bytes) : unzstd(pack, bytes);
  } catch (error) {
    throw error instanceof Failure ? error : damaged(pack, compression, error as Error);
  }
}

function gunzipped(bytes: Uint8Array): Uint8Array {
  // the types of Node don't know of `info`
  const { buffer, engine } = zlib.gunzipSync(bytes, { maxOutputLength: MOST_UNPACKED, info: true } as object) as unknown as {
    readonly buffer: Buffer;
    readonly engine: { readonly bytesWritten: number };
  };
  if (bytes.subarray(engine.bytesWritten).some((byte) => byte !== 0)) throw new Error(AFTER_ZEROS);
  return buffer;
}

function unzstd(pack: string, bytes: Uint8Array): Uint8Array {
  const { zstdDecompressSync } = zlib as { zstdDecompressSync?: typeof zlib.gunzipSync };
  if (zstdDecompressSync === undefined) throw noZstd(pack);
  const contents: Buffer[] = [];
  let left = MOST_UNPACKED;
  for (let from = 0; from < bytes.length; ) {
    const frame = new ZstdFrame();
    const end = from + frame.take(bytes.subarray(from));
    if (!frame.isWhole) throw new Error(UNEXPECTED_END);
    const content = zstdDecompressSync(bytes.subarray(from, end), { maxOutputLength: left });
    contents.push(content);
    left -= content.length;
    from = end;
  }
  return Buffer.concat(contents);
}

/** An entry that a label may mean. */
interface Found {
  readonly content: Uint8Array;
  /** The number of its line; null in an archive. */
  readonly line: number | null;
}

/** The lines that have a name in reports. Without any, a number also stands for a line that has an id. */
function linesOf(bytes: Uint8Array, label: string): Found[] {
  const wanted = /^\d+$/.test(label) ? Number(label) : null;
  const named: Found[] = [];
  const numbered: Found[] = [];
  let line = 0;
  for (let from = 0; from < bytes.length; ) {
    const end = bytes.indexOf(NEWLINE, from);
    const entry = bytes.subarray(from, end < 0 ? bytes.length : end);
    const { id, content } = unwrap(entry);
    line++;
    if (id === label || (id === null && line === wanted && !isBlank([entry]))) named.push({ content, line });
    else if (line === wanted && id !== null) numbered.push({ content, line });
    from += entry.length + 1;
  }
  return named.length > 0 ? named : numbered;
}

function filesOf(pack: string, bytes: Uint8Array, label: string): Found[] {
  const found: Found[] = [];
  const add = (_: string, pieces: readonly Uint8Array[]): void => {
    found.push({ content: Buffer.concat(pieces), line: null });
  };
  const archive = new TarArchive(pack, (name) => name === label, add);
  archive.write(Buffer.from(bytes.buffer, bytes.byteOffset, bytes.length));
  archive.end();
  return found;
}

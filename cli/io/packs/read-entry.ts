import * as zlib from 'node:zlib';
import { Failure, namedPath } from '../messages.ts';
import { readRegularFile, refusePointer } from '../regular-file.ts';
import { packFormat } from './formats.ts';
import { AFTER_ZEROS, damaged, noZstd, UNEXPECTED_END } from './open-pack.ts';
import { isBlank, NEWLINE } from './read-lines.ts';
import { TarArchive } from './tar-archive.ts';
import { unwrap } from './unwrap.ts';
import { ZstdFrame } from './zstd-frame.ts';

/** Bytes of a pack from which a single entry is taken at most, packed and unpacked. */
const MOST_BYTES = 1024 * 1024 * 1024;

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
  const packed = readRegularFile(pack, MOST_BYTES);
  if (packed.length > MOST_BYTES) throw new Failure(`${namedPath(pack)}: it is too large to take out a single entry: unpack it`);
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
  const { buffer, engine } = zlib.gunzipSync(bytes, { maxOutputLength: MOST_BYTES, info: true } as object) as unknown as {
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
  let left = MOST_BYTES;
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

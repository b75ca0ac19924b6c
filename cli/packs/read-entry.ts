import { createRequire } from 'node:module';
import * as zlib from 'node:zlib';
import { Failure } from '../failure.ts';
import { readRegularFile } from '../regular-file.ts';
import { namedPath } from '../shown-path.ts';
import { packFormat } from './formats.ts';
import { unwrap } from './unwrap.ts';

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
  const format = packFormat(pack)!;
  const bytes = format.compression === null ? packed : unpacked(pack, packed, format.compression);
  const found = format.kind === 'tar' ? fileOf(pack, bytes, label) : lineOf(bytes, label);
  if (found !== null) return found;
  const what = format.kind === 'tar' ? 'file of that name' : 'such line or id';
  throw new Failure(`${namedPath(`${pack}#${label}`)}: the pack has no ${what}`);
}

function unpacked(pack: string, bytes: Uint8Array, compression: 'gzip' | 'zstd'): Uint8Array {
  const { zstdDecompressSync } = zlib as { zstdDecompressSync?: typeof zlib.gunzipSync };
  const unpack = compression === 'gzip' ? zlib.gunzipSync : zstdDecompressSync;
  if (unpack === undefined) throw new Failure(`${namedPath(pack)}: this Node can't unpack zstd: expected Node 22.15 or newer`);
  try {
    return unpack(bytes, { maxOutputLength: MOST_BYTES });
  } catch (error) {
    throw new Failure(`${namedPath(pack)}: can't be unpacked (${compression}): ${(error as Error).message}`);
  }
}

function lineOf(bytes: Uint8Array, label: string): Uint8Array | null {
  const wanted = /^\d+$/.test(label) ? Number(label) : null;
  let byNumber: Uint8Array | null = null;
  let number = 0;
  for (let from = 0; from < bytes.length; ) {
    const end = bytes.indexOf(0x0a, from);
    const line = bytes.subarray(from, end < 0 ? bytes.length : end);
    const { id, content } = unwrap(line);
    if (id === label) return content;
    if (++number === wanted) byNumber = content;
    from += line.length + 1;
  }
  return byNumber;
}

function fileOf(pack: string, bytes: Uint8Array, label: string): Uint8Array | null {
  // loaded here, as it takes time that commands on files need not spend
  const { Parser } = createRequire(import.meta.url)('tar') as typeof import('tar');
  let found: Uint8Array | null = null;
  const parser = new Parser({
    strict: true,
    onReadEntry(entry) {
      const pieces: Buffer[] = [];
      if (entry.path === label && found === null) {
        entry.on('data', (piece: Buffer) => pieces.push(piece));
        entry.on('end', () => {
          found = Buffer.concat(pieces);
        });
      } else entry.resume();
    },
  });
  let broken: Error | null = null;
  parser.on('error', (error: Error) => {
    broken ??= error;
  });
  parser.end(Buffer.from(bytes));
  if (broken !== null) throw new Failure(`${namedPath(pack)}: it is no tar archive, or it is damaged`);
  return found;
}

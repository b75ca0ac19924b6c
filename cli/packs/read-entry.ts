import { createRequire } from 'node:module';
import * as zlib from 'node:zlib';
import { Failure } from '../failure.ts';
import { refusePointer } from '../pointer.ts';
import { readRegularFile } from '../regular-file.ts';
import { namedPath } from '../shown-path.ts';
import { packFormat } from './formats.ts';
import { isBlank, NEWLINE } from './read-lines.ts';
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
  const { zstdDecompressSync } = zlib as { zstdDecompressSync?: typeof zlib.gunzipSync };
  const unpack = compression === 'gzip' ? zlib.gunzipSync : zstdDecompressSync;
  if (unpack === undefined) throw new Failure(`${namedPath(pack)}: this Node can't unpack zstd: expected Node 22.15 or newer`);
  try {
    return unpack(bytes, { maxOutputLength: MOST_BYTES });
  } catch (error) {
    throw new Failure(`${namedPath(pack)}: can't be unpacked (${compression}): ${(error as Error).message}`);
  }
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
  // loaded here, as it takes time that commands on files need not spend
  const { Parser } = createRequire(import.meta.url)('tar') as typeof import('tar');
  const found: Found[] = [];
  const parser = new Parser({
    strict: true,
    onReadEntry(entry) {
      const pieces: Buffer[] = [];
      if (entry.path === label) {
        entry.on('data', (piece: Buffer) => pieces.push(piece));
        entry.on('end', () => {
          found.push({ content: Buffer.concat(pieces), line: null });
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

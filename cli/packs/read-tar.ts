import { Parser, type ReadEntry } from 'tar';
import { MAX_FILE_SIZE } from '../../schema/basics/index.ts';
import { Failure } from '../failure.ts';
import { namedPath } from '../shown-path.ts';
import type { Batch, BatchMaker } from './batch.ts';

/** Of a longer file only slightly more than this is kept, which readers then refuse. */
const MOST_BYTES = MAX_FILE_SIZE + 4096;

/** Bytes of a block: headers and contents begin at multiples of it. */
const BLOCK = 512;

/** The first bytes of what gzip has packed; the parser would unpack it unasked, and not in time. */
const GZIP = [0x1f, 0x8b] as const;

/** Types of entries that have no content of their own, in words. */
const OTHERS: Readonly<Record<string, string>> = {
  Link: 'a hard link: pack it with tar --hard-dereference',
  SymbolicLink: 'a symbolic link: pack it with tar --dereference',
};

/**
 * The files of an archive whose names pass.
 * @throws Failure if it is no archive, is cut off or damaged, if a name that passes is not that of a file, or if there is more
 * after the archive's end
 */
export async function* readTar(
  path: string,
  stream: AsyncIterable<Buffer>,
  maker: BatchMaker,
  passes: (name: string) => boolean,
): AsyncGenerator<Batch> {
  let broken: Error | null = null;
  let other: string | null = null;
  const isFile = ({ type, path: name }: ReadEntry): boolean => {
    if (['File', 'OldFile', 'ContiguousFile'].includes(type)) return true;
    other ??= `${namedPath(name)}, which is ${OTHERS[type] ?? `of type ${type}`}`;
    return false;
  };
  const parser = new Parser({
    strict: true,
    onReadEntry(entry: ReadEntry) {
      if (!passes(entry.path) || !isFile(entry)) {
        entry.resume();
        return;
      }
      const pieces: Uint8Array[] = [];
      let length = 0;
      entry.on('data', (piece: Buffer) => {
        if (length < MOST_BYTES) pieces.push(Buffer.from(piece.subarray(0, MOST_BYTES - length)));
        length += piece.length;
      });
      entry.on('end', () => maker.add(entry.path, pieces));
    },
  });
  parser.on('error', (error: Error) => {
    broken ??= error;
  });
  // those that the parser cannot read
  parser.on('ignoredEntry', (entry: ReadEntry) => {
    if (passes(entry.path)) isFile(entry);
  });
  let hasEnded = false;
  parser.on('eof', () => {
    hasEnded = true;
  });
  const refuseBroken = (): void => {
    if (other !== null) throw new Failure(`${namedPath(path)}: expected only files of that name, found ${other}`);
    if (broken === null) return;
    throw new Failure(
      `${namedPath(path)}: it is no tar archive, or it is cut off or damaged: ${(broken as Error).message.split('\n')[0]}`,
    );
  };
  let offset = 0;
  for await (const piece of stream) {
    if (offset === 0 && piece[0] === GZIP[0] && piece[1] === GZIP[1]) {
      throw new Failure(`${namedPath(path)}: it is packed with gzip: expected a name that ends in .tgz or .tar.gz`);
    }
    for (const part of partsOf(piece, offset)) {
      if (!hasEnded) parser.write(part);
      else if (part.some((byte) => byte !== 0)) {
        throw new Failure(
          `${namedPath(path)}: there is more after the end of the archive, as when several are joined: expected a pack for each; tar --concatenate joins them`,
        );
      }
    }
    offset += piece.length;
    refuseBroken();
    yield* maker.take();
  }
  parser.end();
  refuseBroken();
  yield* maker.take();
}

/**
 * Cuts a piece of an archive where its end may be: after a block that begins with a zero, as the end does and names don't.
 * @param offset bytes of the archive before the piece
 */
function* partsOf(piece: Buffer, offset: number): Generator<Buffer> {
  const rest = (BLOCK - (offset % BLOCK)) % BLOCK;
  if (rest > 0) yield piece.subarray(0, rest);
  let from = rest;
  for (let at = rest; at < piece.length; at += BLOCK) {
    if (piece[at] !== 0) continue;
    const end = Math.min(at + BLOCK, piece.length);
    yield piece.subarray(from, end);
    from = end;
  }
  if (from < piece.length) yield piece.subarray(from);
}

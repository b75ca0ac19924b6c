import { createRequire } from 'node:module';
import type { Parser, ReadEntry } from 'tar';
import { Failure, namedPath } from '../../terminal/index.ts';
import { type Batch, type BatchMaker, MOST_OF_ENTRY } from './batch.ts';

/** Bytes of a block: headers and contents begin at multiples of it. */
const BLOCK = 512;

/** The first bytes of what gzip has packed; the parser would unpack it unasked, and not in time. */
const GZIP = [0x1f, 0x8b] as const;

/** Types of entries that have no content of their own, in words. */
const OTHERS: Readonly<Record<string, string>> = {
  Link: 'a hard link: pack it with tar --hard-dereference',
  SymbolicLink: 'a symbolic link: pack it with tar --dereference',
};

/** A file of an archive. Its pieces have memory of their own. */
type Found = (name: string, pieces: readonly Uint8Array[]) => void;

/**
 * Takes the files out of an archive, whose bytes it gets in pieces of any length. An archive that has no end is cut off: files may
 * be missing, and nothing else would tell.
 */
export class TarArchive {
  private readonly parser: Parser;
  private offset = 0;
  private broken: Error | null = null;
  private other: string | null = null;
  private hasEnded = false;
  /** The name of the last entry. */
  private last: string | null = null;

  /** @param passes says by its name whether a file is wanted; `found` gets those */
  constructor(
    private readonly path: string,
    private readonly passes: (name: string) => boolean,
    found: Found,
  ) {
    // loaded here, as it takes time that commands on files need not spend
    const tar = createRequire(import.meta.url)('tar') as typeof import('tar');
    this.parser = new tar.Parser({ strict: true, onReadEntry: (entry: ReadEntry) => this.read(entry, found) });
    this.parser.on('error', (error: Error) => {
      this.broken ??= error;
    });
    // those that the parser cannot read
    this.parser.on('ignoredEntry', (entry: ReadEntry) => {
      if (passes(entry.path)) this.isFile(entry);
    });
    this.parser.on('eof', () => {
      this.hasEnded = true;
    });
  }

  /** @throws Failure if it is no archive, if a name that passes is not that of a file, or if there is more after its end */
  write(piece: Buffer): void {
    if (this.offset === 0 && piece[0] === GZIP[0] && piece[1] === GZIP[1])
      throw this.failure('it is packed with gzip: expected a name that ends in .tgz or .tar.gz');
    for (const part of partsOf(piece, this.offset)) {
      if (!this.hasEnded) this.parser.write(part);
      else if (part.some((byte) => byte !== 0)) {
        throw this.failure(
          'there is more after the end of the archive, as when several are joined: expected a pack for each; tar --concatenate joins them',
        );
      }
    }
    this.offset += piece.length;
    this.refuseBroken();
  }

  /** To be called after the last piece. @throws Failure if the archive is cut off */
  end(): void {
    if (this.hasEnded) {
      this.parser.end();
      this.refuseBroken();
      return;
    }
    const where = this.last === null ? '' : `, after the entry ${namedPath(this.last)}`;
    throw this.failure(
      `the archive is cut off: expected two blocks of zeros, with which an archive ends, found the end of its data at byte ${this.offset}${where}: files may be missing; copy or pack it again`,
    );
  }

  private read(entry: ReadEntry, found: Found): void {
    this.last = entry.path;
    if (!this.passes(entry.path) || !this.isFile(entry)) {
      entry.resume();
      return;
    }
    const pieces: Uint8Array[] = [];
    let length = 0;
    entry.on('data', (piece: Buffer) => {
      if (length < MOST_OF_ENTRY) pieces.push(Buffer.from(piece.subarray(0, MOST_OF_ENTRY - length)));
      length += piece.length;
    });
    entry.on('end', () => found(entry.path, pieces));
  }

  private isFile({ type, path: name }: ReadEntry): boolean {
    if (['File', 'OldFile', 'ContiguousFile'].includes(type)) return true;
    this.other ??= `${namedPath(name)}, which is ${OTHERS[type] ?? `of type ${type}`}`;
    return false;
  }

  private refuseBroken(): void {
    if (this.other !== null) throw this.failure(`expected only files of that name, found ${this.other}`);
    if (this.broken === null) return;
    throw this.failure(`it is no tar archive, or it is damaged: ${this.broken.message.split('\n')[0]}`);
  }

  private failure(what: string): Failure {
    return new Failure(`${namedPath(this.path)}: ${what}`);
  }
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
  const archive = new TarArchive(path, passes, (name, pieces) => maker.add(name, pieces));
  for await (const piece of stream) {
    archive.write(piece);
    yield* maker.take();
  }
  archive.end();
  yield* maker.take();
}

import { MAX_FILE_SIZE } from '../../../schema/basics/index.ts';
import { Failure } from '../../terminal/index.ts';

/** Of a longer entry only slightly more bytes than this are kept, which readers then refuse. */
export const MOST_OF_ENTRY = MAX_FILE_SIZE + 4096;

/** What the entries of a set are. */
export type Contents = 'levels' | 'plays';

/** Consecutive entries of a set, as a thread gets them. */
export interface Batch {
  /** The number of its first entry within the set, from 0. */
  readonly first: number;
  /** Files to read, or entries of a pack. */
  readonly source: FilesOf | EntriesOf;
}

interface FilesOf {
  readonly files: readonly string[];
}

interface EntriesOf {
  readonly pack: string;
  readonly kind: PackFormat['kind'];
  /** Names of files in the archive, or numbers of lines. */
  readonly labels: readonly (string | number)[];
  /** The entries, one directly after the other. */
  readonly bytes: Uint8Array;
  /** Where each entry ends. */
  readonly ends: readonly number[];
}

/** The number of entries in a batch. */
export const sizeOf = ({ source }: Batch): number => ('files' in source ? source.files.length : source.labels.length);

/** Entries and bytes of a batch at most; a single longer entry makes a batch of its own. */
export interface BatchLimits {
  readonly entries: number;
  readonly bytes: number;
}

/** Collects the entries of a pack into batches. */
export class BatchMaker {
  private labels: (string | number)[] = [];
  private pieces: Uint8Array[] = [];
  private ends: number[] = [];
  private total = 0;
  private full: Batch[] = [];

  /** @param first the number of the first entry within the set */
  constructor(
    private readonly pack: string,
    private readonly kind: PackFormat['kind'],
    private first: number,
    private readonly limits: BatchLimits,
  ) {}

  /** @param entry its memory is used until the batches are taken */
  add(label: string | number, entry: readonly Uint8Array[]): void {
    for (const piece of entry) {
      this.pieces.push(piece);
      this.total += piece.length;
    }
    this.labels.push(label);
    this.ends.push(this.total);
    if (this.labels.length >= this.limits.entries || this.total >= this.limits.bytes) this.endBatch();
  }

  /** All entries since the last call. */
  take(): Batch[] {
    if (this.labels.length > 0) this.endBatch();
    const { full } = this;
    this.full = [];
    return full;
  }

  private endBatch(): void {
    const { labels, ends } = this;
    // memory of its own: Buffer.concat may use some that it shares with others, which can't go to another thread
    const bytes = new Uint8Array(this.total);
    let at = 0;
    for (const piece of this.pieces) {
      bytes.set(piece, at);
      at += piece.length;
    }
    this.full.push({ first: this.first, source: { pack: this.pack, kind: this.kind, labels, bytes, ends } });
    this.first += labels.length;
    this.labels = [];
    this.pieces = [];
    this.ends = [];
    this.total = 0;
  }
}

/** How a pack holds its entries, and how it is compressed. */
export interface PackFormat {
  /** `ndjson`: a level or a play a line; `tar`: an archive of files. */
  readonly kind: 'ndjson' | 'tar';
  readonly compression: 'gzip' | 'zstd' | null;
}

const PACK = /\.(ndjson|tar)(?:\.(gz|zst))?$|\.(tgz)$/i;

/** The format of a pack by the name of its file; null if the file is no pack. */
export function packFormat(path: string): PackFormat | null {
  const found = PACK.exec(path);
  if (found === null) return null;
  const [, kind, compression, short] = found;
  if (short !== undefined) return { kind: 'tar', compression: 'gzip' };
  const compressions = { gz: 'gzip', zst: 'zstd' } as const;
  return {
    kind: kind.toLowerCase() as PackFormat['kind'],
    compression: compression === undefined ? null : compressions[compression.toLowerCase() as keyof typeof compressions],
  };
}

/** The first of the files that is a pack; undefined if none is. */
export const firstPack = (files: readonly string[]): string | undefined => files.find((file) => packFormat(file) !== null);

/** Bytes at the begin or end of a line in which the id of a level must be. */
const NEAR = 1024;

const ID = String.raw`("(?:[^"\\]|\\.){0,200}"|-?\d{1,15})`;
const BEGIN = new RegExp(String.raw`^\s*\{\s*(?:"id"\s*:\s*${ID}\s*,\s*)?"level"\s*:\s*`, 's');
const END = new RegExp(String.raw`(?:,\s*"id"\s*:\s*${ID}\s*)?\}\s*$`, 's');

/** A level in a line, and the id that it has there. */
interface Unwrapped {
  /** null: the line is a level, or gives it no id. */
  readonly id: string | null;
  readonly content: Uint8Array;
}

/**
 * Takes a level out of `{"id": ..., "level": {...}}`, byte by byte as it stands there. Any other line is taken for a level itself,
 * and so its reader says what is wrong with it.
 */
export function unwrap(line: Uint8Array): Unwrapped {
  const whole: Unwrapped = { id: null, content: line };
  const bytes = Buffer.from(line.buffer, line.byteOffset, line.length);
  // one character for each byte, so that places in the text are places in the bytes
  const begin = BEGIN.exec(bytes.toString('latin1', 0, NEAR));
  if (begin === null) return whole;
  const from = begin[0].length;
  const tail = Math.max(from, bytes.length - NEAR);
  const end = END.exec(bytes.toString('latin1', tail));
  if (end === null) return whole;
  const text = begin[1] ?? end[1];
  if (begin[1] !== undefined && end[1] !== undefined) return whole;
  const id = text === undefined ? null : idOf(text);
  return id === undefined ? whole : { id, content: line.subarray(from, tail + end.index) };
}

/** @param text the id as JSON; undefined if it is none, such as one with a tab or an unknown escape */
function idOf(text: string): string | undefined {
  try {
    return String(JSON.parse(Buffer.from(text, 'latin1').toString('utf8')));
  } catch {
    return undefined;
  }
}

/** A level or a play of a set. */
export interface Entry {
  /** The path of its file, or where it is in its pack: `pack.tar#a.level.json`, `pack.ndjson#12` for a line, `pack.ndjson#ID`. */
  readonly name: string;
  /** A Failure if its file can't be read. */
  readonly content: Uint8Array | Failure;
}

/**
 * The entries of a batch, in their order.
 * @param readFile reads a file; throws a Failure if it can't be read
 */
export function* entriesOf({ source }: Batch, contents: Contents, readFile: (path: string) => Uint8Array): Generator<Entry> {
  if ('files' in source) {
    for (const name of source.files) yield { name, content: read(name, readFile) };
    return;
  }
  const { pack, kind, labels, bytes, ends } = source;
  let from = 0;
  for (const [i, label] of labels.entries()) {
    const content = bytes.subarray(from, ends[i]);
    from = ends[i];
    if (kind === 'tar' || contents === 'plays') yield { name: `${pack}#${label}`, content };
    else {
      const { id, content: level } = unwrap(content);
      yield { name: `${pack}#${id ?? label}`, content: level };
    }
  }
}

function read(file: string, readFile: (path: string) => Uint8Array): Uint8Array | Failure {
  try {
    return readFile(file);
  } catch (error) {
    if (error instanceof Failure) return error;
    throw error;
  }
}

import type { PackFormat } from './formats.ts';

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

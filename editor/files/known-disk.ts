import type { LevelFile } from '../../schema/index.ts';
import { type EditedLevel, isSame } from '../document/index.ts';

/** What was on the disk when it was last looked at or written. */
export interface DiskBase {
  readonly file: LevelFile;
  /** null: not on the disk */
  readonly etag: string | null;
  /** Sent to the disk since, without an answer: each of them may be what is there. None when left out. */
  readonly sent?: readonly LevelFile[];
}

/** What a page knows of a level's file on the disk, and whether the level differs from it. */
export class KnownDisk {
  private now: DiskBase;
  /** The level is to be written even if it is the same. */
  private isForced = false;

  /** @param onDisk called with what is on the disk whenever that is known anew */
  constructor(
    private readonly level: EditedLevel,
    base: DiskBase,
    private readonly onDisk: ((file: LevelFile, etag: string | null) => void) | undefined,
  ) {
    this.now = base;
  }

  get base(): DiskBase {
    return this.now;
  }

  get sent(): readonly LevelFile[] {
    return this.now.sent ?? [];
  }

  /** Whether the level differs from what is known to be on the disk, or nothing is known for certain. */
  differs(): boolean {
    const { file, etag } = this.now;
    return this.isForced || this.sent.length > 0 || !isSame(this.level.settledFile(), file) || etag === null;
  }

  /** This is on the disk: it was read there, or the write of it was answered. */
  holds(file: LevelFile, etag: string | null): void {
    this.now = { file, etag };
    this.onDisk?.(file, etag);
  }

  /** This may be on the disk from now on. @returns takes that back: it has not got there */
  sends(file: LevelFile): () => void {
    const before = this.sent;
    this.now = { ...this.now, sent: [...before.filter((other) => other !== file), file] };
    return () => {
      this.now = { ...this.now, sent: before };
    };
  }

  /** A write has reached the disk. */
  written(file: LevelFile, etag: string | null): void {
    this.isForced = false;
    this.holds(file, etag);
  }

  /** The next write takes the place of what is there, whatever that is. */
  overwrite(file: LevelFile, etag: string | null): void {
    this.now = { file, etag };
    this.isForced = true;
  }

  /** Begins anew from what was known earlier. */
  restart(base: DiskBase): void {
    this.now = base;
  }

  /** The same file has another name, and with it another etag. */
  moved(etag: string): void {
    this.now = { ...this.now, etag };
  }
}

import { type Merged, mergeLevels } from '../../../review/index.ts';
import { isSame, type LevelFile, type Problem, type ReadResponse } from '../../../schema/index.ts';
import type { EditedLevel } from '../document/index.ts';
import { readStored } from './read-text.ts';

/** What was on disk when it was last read or written. */
export interface DiskBase {
  readonly file: LevelFile;
  /** null: not on disk */
  readonly etag: string | null;
  /** Versions that were sent since and not answered: each may be on disk. None if absent. */
  readonly sent?: readonly LevelFile[];
}

/** What a page knows about a level's file on disk, and whether the level differs from it. */
export class KnownDisk {
  private now: DiskBase;
  /** Whether the level must be written even if it does not differ. */
  private isForced = false;

  /** @param onDisk called whenever the state on disk becomes known, and who wrote it: this page or another program */
  constructor(
    private readonly level: EditedLevel,
    base: DiskBase,
    private readonly onDisk: ((file: LevelFile, etag: string | null, by: 'page' | 'other') => void) | undefined,
  ) {
    this.now = base;
  }

  get base(): DiskBase {
    return this.now;
  }

  get sent(): readonly LevelFile[] {
    return this.now.sent ?? [];
  }

  /** Whether the level differs from the file on disk, or the state of the file is uncertain. */
  differs(): boolean {
    const { file, etag } = this.now;
    return this.isForced || this.sent.length > 0 || !isSame(this.level.committedFile(), file) || etag === null;
  }

  /** This version is on disk: it was read, or its write was confirmed. */
  holds(file: LevelFile, etag: string | null, by: 'page' | 'other'): void {
    this.now = { file, etag };
    this.onDisk?.(file, etag, by);
  }

  /** This version may be on disk from now on. @returns undoes this, if it was not sent after all */
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
    this.holds(file, etag, 'page');
  }

  /** The next write replaces whatever is on disk. */
  overwrite(file: LevelFile, etag: string | null): void {
    this.now = { file, etag };
    this.isForced = true;
  }

  /** Starts over from an earlier state of knowledge. */
  restart(base: DiskBase): void {
    this.now = base;
  }

  /** The file was renamed and has a new etag. */
  moved(etag: string): void {
    this.now = { ...this.now, etag };
  }
}

/** What a look at the disk means for a level. */
type DiskNews =
  /** nothing new */
  | { readonly kind: 'known' }
  | { readonly kind: 'deleted' }
  /** the file is not a level */
  | { readonly kind: 'unreadable'; readonly problems: readonly Problem[] }
  /** a version that this page has sent: the server died or the connection broke before the answer */
  | { readonly kind: 'own'; readonly file: LevelFile }
  /** another version, and this page has no changes */
  | { readonly kind: 'changed'; readonly theirs: LevelFile }
  /** another version, and this page has changes as well */
  | { readonly kind: 'both changed'; readonly theirs: LevelFile; readonly merged: Merged };

/**
 * What is new on disk. Ends a gesture in progress if there is something to merge. @param current the file; null if there is
 * none
 */
export function diskNews(level: EditedLevel, disk: KnownDisk, current: ReadResponse | null): DiskNews {
  if (current === null) return { kind: 'deleted' };
  if (current.etag === disk.base.etag) return { kind: 'known' };
  const reading = readStored(current);
  if (!reading.ok) return { kind: 'unreadable', problems: reading.problems };
  const theirs = reading.file;
  const own = disk.sent.find((file) => isSame(file, theirs));
  if (own !== undefined) return { kind: 'own', file: own };
  // a drag in progress counts as mine as far as it went
  level.seal();
  if (!disk.differs()) return { kind: 'changed', theirs };
  const merged = mergeLevels(disk.base.file, level.committedFile(), theirs, new Map(), disk.sent);
  return { kind: 'both changed', theirs, merged };
}

import type { LevelFile, Problem, ReadResponse } from '../../schema/index.ts';
import { type EditedLevel, isSame } from '../document/index.ts';
import { readStored } from './disk-text.ts';
import type { KnownDisk } from './known-disk.ts';
import { type Merged, mergeLevels } from './merge.ts';

/** What a look at the disk means for a level. */
export type DiskNews =
  /** Nothing new. */
  | { readonly kind: 'known' }
  | { readonly kind: 'deleted' }
  /** The file is no level. */
  | { readonly kind: 'unreadable'; readonly problems: readonly Problem[] }
  /** What this page has sent: the server died, or the line broke, before it could answer. */
  | { readonly kind: 'own'; readonly file: LevelFile }
  /** Another level, and this page has changed nothing. */
  | { readonly kind: 'changed'; readonly theirs: LevelFile }
  /** Another level, and this page has changed something, too. */
  | { readonly kind: 'both changed'; readonly theirs: LevelFile; readonly merged: Merged };

/** What is new on the disk. Seals what goes on in the level where that counts. @param current what is there; null: nothing */
export function diskNews(level: EditedLevel, disk: KnownDisk, current: ReadResponse | null): DiskNews {
  if (current === null) return { kind: 'deleted' };
  if (current.etag === disk.base.etag) return { kind: 'known' };
  const reading = readStored(current);
  if (!reading.ok) return { kind: 'unreadable', problems: reading.problems };
  const theirs = reading.file;
  const own = disk.sent.find((file) => isSame(file, theirs));
  if (own !== undefined) return { kind: 'own', file: own };
  // a drag that goes on is mine as far as it went
  level.seal();
  if (!disk.differs()) return { kind: 'changed', theirs };
  const merged = mergeLevels(disk.base.file, level.settledFile(), theirs, new Map(), disk.sent);
  return { kind: 'both changed', theirs, merged };
}

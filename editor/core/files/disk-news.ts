import { type Merged, mergeLevels } from '../../../review/index.ts';
import { isSame, type LevelFile, type Problem, type ReadResponse } from '../../../schema/index.ts';
import type { EditedLevel } from '../document/index.ts';
import { readStored } from './disk-text.ts';
import type { KnownDisk } from './known-disk.ts';

/** What a look at the disk means for a level. */
export type DiskNews =
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

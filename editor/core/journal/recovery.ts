import { type LevelFile, readLevel } from '../../../schema/index.ts';
import { applyPatches, settle } from '../document/index.ts';
import type { JournalEntry, Kept } from './journal-store.ts';

/** Changes that never reached the disk. */
export interface Recovery {
  /** The version that the changes started from; the disk may instead have one of `sent`, which were in flight. */
  readonly base: { readonly file: LevelFile; readonly etag: string | null; readonly sent: readonly LevelFile[] };
  /** The level with all changes that could be read. */
  readonly file: LevelFile;
  /** Labels of the changes, oldest first; those that were merged into one text are missing. */
  readonly labels: readonly string[];
  /** When the last change was made, ms since 1970. */
  readonly time: number;
  /** The number of changes at the end that could not be read. */
  readonly lost: number;
}

function fileOf(text: string): LevelFile | null {
  const reading = readLevel(text);
  if (!reading.ok) return null;
  const settled = settle(reading.document.file, null);
  return settled.ok ? settled.file : null;
}

/** Applies entries as far as possible: each must follow the one before and must fit. */
function replay(start: LevelFile, first: number, entries: readonly JournalEntry[]): { files: LevelFile[]; labels: string[] } {
  let file = start;
  const files: LevelFile[] = [];
  const labels: string[] = [];
  for (const [i, { number, label, patches }] of entries.entries()) {
    if (number !== first + i) break;
    try {
      const next = settle(applyPatches(file, patches), null);
      if (!next.ok) break;
      file = next.file;
    } catch {
      break;
    }
    files.push(file);
    labels.push(label);
  }
  return { files, labels };
}

/** The unsaved changes of a level; null if everything reached the disk. */
export function recoveryOf(found: Kept): Recovery | null {
  if (found.entries.length === 0 && found.tip === null) return null;
  const base = fileOf(found.base.text);
  if (base === null) return null;
  const start = found.tip === null ? base : fileOf(found.tip.text);
  const first = found.tip === null ? (found.entries[0]?.number ?? 0) : found.tip.number + 1;
  const { files, labels } = start === null ? { files: [], labels: [] } : replay(start, first, found.entries);
  const lost = found.entries.length - labels.length + (start === null ? 1 : 0);
  const file = files.at(-1) ?? start ?? base;
  // a save may have been cut off after any step, so each state may be this level's own version on disk
  const isFile = (read: LevelFile | null) => read !== null;
  const sent = [...(found.base.sent ?? []).map(fileOf), found.tip === null ? null : start, ...files].filter(isFile);
  return { base: { file: base, etag: found.base.etag, sent }, file, labels, time: found.time, lost };
}

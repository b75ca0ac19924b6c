import { type LevelFile, readLevel } from '../../schema/index.ts';
import { applyPatches, settle } from '../document/index.ts';
import type { JournalEntry, Kept } from './journal-store.ts';

/** What was changed and never reached the disk. */
export interface Recovery {
  /** What the changes began with, and what the disk may have instead: whatever was on the way from there. */
  readonly base: { readonly file: LevelFile; readonly etag: string | null; readonly sent: readonly LevelFile[] };
  /** With all changes that could be read. */
  readonly file: LevelFile;
  /** Labels of the changes, the oldest first; those folded into one text are missing. */
  readonly labels: readonly string[];
  /** When the last one was made, ms since 1970. */
  readonly time: number;
  /** How many changes at the end could not be read. */
  readonly lost: number;
}

function fileOf(text: string): LevelFile | null {
  const reading = readLevel(text);
  if (!reading.ok) return null;
  const settled = settle(reading.document.file, null);
  return settled.ok ? settled.file : null;
}

/** Applies entries as far as they go: each must follow the one before, and fit. */
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

/** What was left of a level; null when all of it reached the disk. */
export function recoveryOf(found: Kept): Recovery | null {
  if (found.entries.length === 0 && found.tip === null) return null;
  const base = fileOf(found.base.text);
  if (base === null) return null;
  const start = found.tip === null ? base : fileOf(found.tip.text);
  const first = found.tip === null ? (found.entries[0]?.number ?? 0) : found.tip.number + 1;
  const { files, labels } = start === null ? { files: [], labels: [] } : replay(start, first, found.entries);
  const lost = found.entries.length - labels.length + (start === null ? 1 : 0);
  const file = files.at(-1) ?? start ?? base;
  // a save may have been cut off after any step: what it wrote is this level's own
  const isFile = (read: LevelFile | null) => read !== null;
  const sent = [...(found.base.sent ?? []).map(fileOf), found.tip === null ? null : start, ...files].filter(isFile);
  return { base: { file: base, etag: found.base.etag, sent }, file, labels, time: found.time, lost };
}

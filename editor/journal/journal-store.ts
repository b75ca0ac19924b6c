import type { Patch } from '../document/index.ts';

/** One step of one level. */
export interface JournalEntry {
  /** Counts up within a level, without gaps. */
  readonly number: number;
  readonly label: string;
  readonly patches: readonly Patch[];
}

/** Text of a level, and the etag under which it was on the disk; null when it never was. */
export interface JournalBase {
  readonly text: string;
  readonly etag: string | null;
  /** Texts sent to the disk since, without an answer. None when left out. */
  readonly sent?: readonly string[];
}

/** What is kept of one level. */
export interface Kept {
  readonly place: string;
  /** What was on the disk when the entries began. */
  readonly base: JournalBase;
  /** The level after entry `number`, where entries before it have been folded into one text. */
  readonly tip: { readonly text: string; readonly number: number } | null;
  /** In order. */
  readonly entries: readonly JournalEntry[];
  /** When something was last kept, ms since 1970. */
  readonly time: number;
}

/** Changes of what is kept of one level; all or nothing. */
export interface JournalWrite {
  readonly place: string;
  readonly time: number;
  readonly base?: JournalBase;
  readonly tip?: Kept['tip'];
  /** Entries up to this number are no longer needed. */
  readonly dropUpTo?: number;
  readonly add: readonly JournalEntry[];
}

/** Where the journal is kept. Every promise rejects when the database fails; nothing is half done then. */
export interface JournalStore {
  write(change: JournalWrite): Promise<void>;
  read(place: string): Promise<Kept | null>;
  places(): Promise<readonly { readonly place: string; readonly time: number; readonly entries: number }[]>;
  /** Forgets a level. */
  remove(place: string): Promise<void>;
}

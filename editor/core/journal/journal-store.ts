import type { Patch } from '../document/index.ts';

/** One step of one level. */
export interface JournalEntry {
  /** counts up within a level, without gaps */
  readonly number: number;
  readonly label: string;
  readonly patches: readonly Patch[];
}

/** The text of a level and its etag on disk; null if it never was on disk. */
export interface JournalBase {
  readonly text: string;
  readonly etag: string | null;
  /** Texts that were sent since and not answered. None if absent. */
  readonly sent?: readonly string[];
}

/** The data of one level. */
export interface Kept {
  readonly place: string;
  /** The state on disk when the entries began. */
  readonly base: JournalBase;
  /** The level after entry `number`, if earlier entries were merged into one text. */
  readonly tip: { readonly text: string; readonly number: number } | null;
  /** in order */
  readonly entries: readonly JournalEntry[];
  /** when something was last kept, ms since 1970 */
  readonly time: number;
}

/** A change of the data of one level; atomic. */
export interface JournalWrite {
  readonly place: string;
  readonly time: number;
  readonly base?: JournalBase;
  readonly tip?: Kept['tip'];
  /** Entries up to this number are no longer needed. */
  readonly dropUpTo?: number;
  readonly add: readonly JournalEntry[];
}

/** Where the journal is kept. Every promise rejects when the database fails; then nothing is changed. */
export interface JournalStore {
  write(change: JournalWrite): Promise<void>;
  read(place: string): Promise<Kept | null>;
  places(): Promise<readonly { readonly place: string; readonly time: number; readonly entries: number }[]>;
  /** Deletes the data of a level. */
  remove(place: string): Promise<void>;
}

import type { Hold, RunNote } from '../../basics/index.ts';

/** What a run as text says. */
export interface RunScript {
  /** When the gun is held. */
  readonly holds: readonly Hold[];
  /** Notes at ticks, sorted by tick. */
  readonly notes: readonly RunNote[];
}

/** A place in a run as text. */
export interface RunTextPlace {
  /** From 0, in UTF-16 code units. */
  readonly offset: number;
  /** From 1. */
  readonly line: number;
  /** From 1, in UTF-16 code units. */
  readonly column: number;
}

/** What the reader did that its text does not say: holds were joined, or a time was rounded. */
export interface RunTextRemark extends RunTextPlace {
  /** A sentence without its first capital and its full stop. */
  readonly message: string;
}

/** What a run as text says, or what is wrong with the text. */
export type RunTextReading =
  | (RunScript & { readonly ok: true; readonly remarks: readonly RunTextRemark[] })
  | (RunTextPlace & {
      readonly ok: false;
      /** What was expected, and what was found. */
      readonly message: string;
      /** What to do. */
      readonly hint: string;
    });

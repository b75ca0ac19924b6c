import type { Level, LevelDocument, Problem } from '../../../schema/index.ts';

/** A level that was read. */
export interface ReadFile {
  readonly file: string;
  readonly level: Level;
  readonly source: LevelDocument;
}

/** A file that cannot be exported, and why. */
export interface Refused {
  readonly file: string;
  readonly problems: readonly Problem[];
  /** The text of the file. */
  readonly text: string;
}

/** Files to write, and what they do not say. */
export interface Made {
  readonly files: readonly {
    /** Its name; `-` for standard output. */
    readonly file: string;
    /** The level files that are in it. */
    readonly levels: readonly string[];
    readonly text: string;
  }[];
  readonly warnings: readonly { readonly file: string; readonly message: string }[];
}

import { type ConfiguredTerms, type TermsOptions, termsFrom } from '../terms.ts';

/** Under which terms each side is judged: those of its own configuration, unless options say otherwise. */
export const termsOfSides = ({ before, after }: Pick<Comparison, 'before' | 'after'>, options: TermsOptions) => ({
  before: termsFrom(options, before.configured),
  after: termsFrom(options, after.configured),
});

/** One version of a level file. */
export interface FileVersion {
  /** Its path for people and reports, relative to the working directory. */
  readonly path: string;
  readonly bytes: Uint8Array;
}

/** Two versions of a level file; null where there is none. */
export interface Pair {
  readonly before: FileVersion | null;
  readonly after: FileVersion | null;
}

/** One side of a comparison. */
export interface Side {
  /** What it is: `HEAD`, `the working tree`, a path. */
  readonly label: string;
  /** What its configuration says about terms. */
  readonly configured: ConfiguredTerms;
}

/** What is to be compared. */
export interface Comparison {
  readonly before: Side;
  readonly after: Side;
  /** Files that differ, sorted by path. */
  readonly pairs: readonly Pair[];
  /** Files that are equal on both sides. They are read only where what the configurations say differs, since every level may then play differently. */
  readonly equal: readonly FileVersion[];
  /** Messages for people. */
  readonly messages: readonly string[];
}

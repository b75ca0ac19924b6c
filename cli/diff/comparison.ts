import type { Terms } from '../../engine/index.ts';
import type { Change, VersionStanding } from '../../review/index.ts';
import type { TermsReport, Verdict } from '../../schema/index.ts';
import type { ConfiguredTerms } from '../config/index.ts';
import { type TermsOptions, termsFrom } from '../options/index.ts';
import type { ShownProblem } from '../report-parts/index.ts';

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

/** One version of a level, judged. */
export interface JudgedVersion {
  /** The path of its file. */
  readonly file: string;
  /** The name of the level; of its file if it is not valid. */
  readonly name: string;
  /** Under which terms it was judged. */
  readonly terms: TermsReport;
  readonly verdict: Verdict;
  /** Why it is not a valid level; empty for one that is. */
  readonly problems: readonly ShownProblem[];
  /** null if it is not a valid level. */
  readonly standing: VersionStanding | null;
}

/** What became of a level file. `layout`: its content is the same; `rules`: the file is, and the rules of its folder are not. */
export type DiffStatus = 'added' | 'removed' | 'changed' | 'renamed' | 'layout' | 'rules';

/** What changed in one level file. This is plain data that a worker can send. */
export interface DiffedLevel {
  readonly status: DiffStatus;
  readonly before: JudgedVersion | null;
  readonly after: JudgedVersion | null;
  /** What turns the first version into the second; null unless both are valid levels. */
  readonly changes: readonly Change[] | null;
  /** The changes, in words. */
  readonly words: readonly string[];
  /** What follows from them, in words. */
  readonly effects: readonly string[];
}

/** How levels are judged. */
export interface DiffSettings {
  /** Under which each side is judged: those of its own configuration, unless options say otherwise. */
  readonly terms: { readonly before: Terms; readonly after: Terms };
  /** Whether to measure slack. */
  readonly slack: boolean;
}

/** A message to a worker. */
export interface DiffTask {
  readonly pair: Pair;
  readonly settings: DiffSettings;
}

import type { Level, Rules } from '../../schema/index.ts';
import type { Box } from '../contact/index.ts';
import type { Run } from '../simulate.ts';
import type { Body } from './bodies.ts';
import type { Copies } from './copies.ts';
import type { Reach } from './reach.ts';

/** Something about a valid level that its designer most likely didn't mean. */
export interface Warning {
  readonly code: string;
  readonly severity: 'warning';
  /** What was found and what was expected, with the numbers. */
  readonly message: string;
  /** What to do about it. */
  readonly hint: string;
  /** JSON pointer into the level file; '' is the whole file. */
  readonly pointer: string;
}

/** What a code means, for `gq explain`. */
export interface WarningExplanation {
  readonly code: string;
  readonly severity: 'warning';
  readonly title: string;
  readonly why: string;
  readonly fix: string;
}

/** What the rules look at, and what several of them need. */
export interface Subject {
  readonly level: Level;
  /** The numbers of the game in this level. */
  readonly rules: Rules;
  readonly box: Box;
  /** Runs of the level that were simulated; may be empty. */
  readonly runs: readonly Run[];
  /** Everything solid. */
  readonly bodies: readonly Body[];
  readonly reach: Reach;
  readonly copies: Copies;
}

/** A warning as a rule gives it: its code and severity are the rule's. */
export interface Finding {
  readonly message: string;
  readonly hint: string;
  readonly pointer: string;
}

/** One thing to look for. `find` is lazy, so that a level with thousands of the same mistake costs no more than it tells. */
export interface Rule {
  readonly explanation: WarningExplanation;
  find(subject: Subject): Iterable<Finding>;
}

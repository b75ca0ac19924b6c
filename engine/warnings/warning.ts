import type { Level, Rules } from '../../schema/basics/index.ts';
import type { Box } from '../contact.ts';
import type { Run } from '../simulate.ts';
import type { Body, Copies } from './bodies.ts';
import type { Reach } from './reach.ts';

/** Something in a valid level that its designer most likely did not intend. */
export interface Warning {
  /** The stable name of this kind of problem, as in `gq explain CODE`. */
  readonly code: string;
  /** Always `warning`. */
  readonly severity: 'warning';
  /** What was found and what was expected, with the numbers. */
  readonly message: string;
  /** What to do about it. */
  readonly hint: string;
  /** JSON pointer into the level file; '' is the whole file. */
  readonly pointer: string;
}

/** The explanation of a code, as `gq explain CODE` prints it. */
export interface WarningExplanation {
  /** The stable name of the kind of problem. */
  readonly code: string;
  /** Always `warning`. */
  readonly severity: 'warning';
  /** What the problem is, in one line. */
  readonly title: string;
  /** Why it matters. */
  readonly why: string;
  /** How to fix it. */
  readonly fix: string;
}

/** What the rules examine: the level, and what several rules need of it. */
export interface Subject {
  readonly level: Level;
  /** The game's rules in this level. */
  readonly rules: Rules;
  readonly box: Box;
  /** Simulated runs of the level; may be empty. */
  readonly runs: readonly Run[];
  /** Everything solid. */
  readonly bodies: readonly Body[];
  readonly reach: Reach;
  readonly copies: Copies;
}

/**
 * One kind of warning. `find` is lazy, so a level with thousands of equal mistakes costs no more than the warnings that are
 * shown.
 */
export interface Rule {
  readonly explanation: WarningExplanation;
  /** Finds such warnings; their code and severity are the rule's. */
  find(subject: Subject): Iterable<Pick<Warning, 'message' | 'hint' | 'pointer'>>;
}

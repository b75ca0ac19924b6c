import type { Hold, LevelFile } from '../../schema/index.ts';
import type { Grade } from '../difficulty/index.ts';
import type { Robustness } from '../robustness/index.ts';

/** A generated level, with what it claims. */
export interface Generated {
  /** With ids, and two runs: `solution`, and `all-minerals`. Ready for `formatLevel`. */
  readonly level: LevelFile;
  /** The run `solution`. */
  readonly holds: readonly Hold[];
  /** Of `solution`, at accuracy `precise`. */
  readonly robustness: Robustness;
  /** Of `solution`, at accuracy `arcade`. */
  readonly arcade: Robustness;
  readonly grade: Grade;
}

/** An attempt at a level: gives the ticks simulated since the last time, and in the end a level, or null when it came to nothing. */
export type Attempt = Generator<number, Generated | null>;

import type { Hold, LevelFile } from '../../schema/index.ts';
import type { Grade } from '../difficulty/index.ts';
import type { Robustness } from '../robustness/index.ts';

/** A generated level with its measurements. */
export interface Generated {
  /** The level file with ids and two runs, `solution` and `all-minerals`, ready for `formatLevel`. */
  readonly level: LevelFile;
  /** The run `solution`, [press, release) in ticks. */
  readonly holds: readonly Hold[];
  /** How robust `solution` is at `precise`. */
  readonly robustness: Robustness;
  /** How robust `solution` is at `arcade`. */
  readonly arcade: Robustness;
  /** The grade of the level, measured at `precise`. */
  readonly grade: Grade;
}

/**
 * An attempt at a level. It yields the ticks simulated since the last time, and returns a level, or null when the attempt
 * failed.
 */
export type Attempt = Generator<number, Generated | null>;

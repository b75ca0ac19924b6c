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
 * Why an attempt was given up: the asteroids did not fit; no run was good enough to build a level around; the level is too easy
 * and nothing makes it harder; it is too hard; its best run forgives too little; no minerals were found that one run collects; a
 * warning is left.
 */
export type Rejection = 'noRoom' | 'noRun' | 'tooEasy' | 'tooHard' | 'unforgiving' | 'noMinerals' | 'warnings';

/** Every reason, in the order in which attempts meet them. */
export const REJECTIONS: readonly Rejection[] = [
  'noRoom',
  'noRun',
  'tooEasy',
  'tooHard',
  'unforgiving',
  'noMinerals',
  'warnings',
];

/** An attempt at a level. It yields the ticks simulated since the last time, and returns a level, or why it failed. */
export type Attempt = Generator<number, Generated | Rejection>;

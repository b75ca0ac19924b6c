import type { Arbitrary } from 'fast-check';
import { ACCURACIES, type AccuracyName } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { arbitraryLevel, arbitraryPlayableLevel } from './arbitrary-level.ts';

/** Every accuracy with a name: what is true of simulations is true at each of them. */
export const accuracyNames = Object.keys(ACCURACIES) as AccuracyName[];

/** Those of continuous time. */
export const continuousNames = accuracyNames.filter((name) => name !== 'arcade');

/** The levels an accuracy is tried on: `arcade` on any at all, continuous time on those in which a run can go on for a while. */
export const levelsFor = (accuracy: AccuracyName): Arbitrary<Level> =>
  accuracy === 'arcade' ? arbitraryLevel : arbitraryPlayableLevel;

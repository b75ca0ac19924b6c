import type { Arbitrary } from 'fast-check';
import { ACCURACIES, type AccuracyName } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { arbitraryLevel, arbitraryPlayableLevel } from './arbitrary-level.ts';

/** Every named accuracy: properties of simulations hold at each of them. */
export const accuracyNames = Object.keys(ACCURACIES) as AccuracyName[];

/** The accuracies in continuous time. */
export const continuousNames = accuracyNames.filter((name) => name !== 'arcade');

/** The levels for tests of an accuracy: any for `arcade`; for continuous time, levels in which a run lasts for a while. */
export const levelsFor = (accuracy: AccuracyName): Arbitrary<Level> =>
  accuracy === 'arcade' ? arbitraryLevel : arbitraryPlayableLevel;

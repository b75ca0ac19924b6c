import { ACCURACIES, type AccuracyName } from '../../engine/index.ts';

/** Every accuracy with a name: what is true of simulations is true at each of them. */
export const accuracyNames = Object.keys(ACCURACIES) as AccuracyName[];

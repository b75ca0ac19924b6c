import { wind } from './wind.ts';
import { wormhole } from './wormhole.ts';

export type { PlacedObject } from './placed-kind.ts';

/**
 * The kinds of objects that a level gets only on request, in the order in which they are placed. Add new kinds at the end, so
 * that existing seeds keep their levels.
 */
export const PLACED_KINDS = [wormhole, wind] as const;

/** The lists of these kinds in a level file. */
export type PlacedList = (typeof PLACED_KINDS)[number]['list'];

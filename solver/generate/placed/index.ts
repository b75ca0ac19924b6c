import { wind } from './wind.ts';
import { wormhole } from './wormhole.ts';

export type { PlacedObject } from './placed-kind.ts';

/** Kinds that a level gets only where they are asked for, in the order in which they are placed. Another one is added at the end. */
export const PLACED_KINDS = [wormhole, wind] as const;

export type PlacedList = (typeof PLACED_KINDS)[number]['list'];

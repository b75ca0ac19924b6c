import { alien } from './alien.ts';
import { repulsor } from './repulsor.ts';
import { wind } from './wind.ts';
import { wormhole } from './wormhole.ts';

export { ALIEN } from './alien.ts';
export type { PlacedObject } from './placed-kind.ts';

/**
 * The kinds of objects that a level may get near its asteroids, in the order in which they are placed. Add new kinds at the end,
 * so that existing seeds keep their levels.
 */
export const PLACED_KINDS = [repulsor, alien, wormhole, wind] as const;

/** The lists of these kinds in a level file. */
export type PlacedList = (typeof PLACED_KINDS)[number]['list'];

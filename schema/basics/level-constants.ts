/** The version of the level format that this toolkit writes. */
export const LEVEL_VERSION = 1;

/** The range of a level that does not set one: farther than this from the centre of every asteroid she is lost, px. */
export const DEFAULT_RANGE = 250;

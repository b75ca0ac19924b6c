// Orders by name, so that a game that includes some effects alone has them in the same order as one with all.

/** The names of all effects. Their hooks are called in this order. */
export const EFFECTS_IN_ORDER: readonly string[] = [
  ...['gun', 'recoil', 'repulsor', 'winds', 'wormholes', 'alien-chase', 'alien-explosion', 'speed-limit', 'novae'],
  ...['hot-asteroids', 'minerals', 'black-hole', 'range'],
];

/** Every kind of event, in the order in which events at the same instant are handled. */
export const EVENTS_IN_ORDER: readonly string[] = [
  ...['mineral', 'nova', 'hot asteroid', 'alien', 'black hole', 'range', 'wormhole', 'mouth', 'centre', 'meeting', 'target'],
  ...['enter', 'leave', 'wind', 'lull', 'wake', 'sleep', 'explosion', 'limit', 'unlimit', 'come off'],
];

/**
 * The neighbour list begins with these. The order matters: the last digit of a tie between two of them can depend on which is
 * examined first.
 */
export const LISTED_FIRST: readonly string[] = ['nova', 'mineral', 'enter', 'black hole', 'alien', 'hot asteroid', 'target'];

/** The effects whose objects end the run by touch. Of two that are equally near, the first in this order counts. */
export const HAZARDS_IN_ORDER: readonly string[] = ['novae', 'hot-asteroids', 'alien-chase'];

/** The effects that accelerate her. Of the central forces only the first that is active acts. */
export const FORCES_IN_ORDER: readonly string[] = ['repulsor', 'gun', 'winds'];

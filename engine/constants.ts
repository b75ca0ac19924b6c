/**
 * Numbers of the game that no level changes. Lengths in px, times in s, angles never: directions are unit vectors.
 * Changing one changes the game; every shipped run and hash must then be made anew.
 */

/** Ticks per second: the button is read at ticks, and `arcade` moves at them. */
export const TICK_RATE = 60;

/** Length of a tick, s. */
export const TICK = 1 / TICK_RATE;

/** `arcade` only: an exploded alien goes on chasing for this many frames (the original's animation). */
export const EXPLOSION_FRAMES = 150;

/** How long a run is simulated when nothing ends it, s. */
export const DEFAULT_MAX_TIME = 60;

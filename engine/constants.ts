/**
 * Numbers of the game that no level changes. Lengths are in px, times in s. There are no angles: directions are unit vectors.
 * Changing one of these changes the game: every shipped run and every hash must then be made anew.
 */

/** Ticks per second. The button is read at ticks, and `arcade` moves at them. */
export const TICK_RATE = 60;

/** Length of a tick, s. */
export const TICK = 1 / TICK_RATE;

/**
 * Frames for which an exploded alien goes on chasing and killing. `arcade` only: it is the length of the original game's
 * animation.
 */
export const EXPLOSION_FRAMES = 150;

/** How long a run is simulated when nothing ends it earlier, s. */
export const DEFAULT_MAX_TIME = 60;

/** The same in ticks. */
export const DEFAULT_MAX_TICKS = DEFAULT_MAX_TIME * TICK_RATE;

/** A level gets at most this many warnings of one code, plus one that says that there are more. */
export const MAX_WARNINGS_PER_CODE = 20;

/** The message of that additional warning. */
export const MORE_WARNINGS = `the level has more warnings of this kind: only the first ${MAX_WARNINGS_PER_CODE} are listed`;

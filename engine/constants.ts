import { DEFAULT_RULES } from '../schema/index.ts';
import { DEFAULT_BOX } from './contact/index.ts';

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

/*
 * The original game's rules, for the proofs and their checker alone, which refuse a level with rules of its own. Everybody else reads
 * the rules of the scene or the level.
 */

/** Half the astronaut's box along its x axis (the axis that points at the target), px. */
export const HALF_WIDTH = DEFAULT_BOX.halfWidth;

/** Half the astronaut's box along its y axis, px. */
export const HALF_HEIGHT = DEFAULT_BOX.halfHeight;

/** Half the box's diagonal rounded up, px: sqrt(10^2 + 16^2) = 18.8679... Any larger bound is right too, only slower. */
export const HALF_DIAGONAL = DEFAULT_BOX.halfDiagonal;

/** Pull of the gun at distance 0, px/s2; it falls linearly to 0 at the range: a = GUN_PULL (1 - d / range). */
export const GUN_PULL = DEFAULT_RULES.pull;

/** Push of a repulsor while her centre is inside, px/s2, instead of the gun's pull. */
export const REPULSOR_PUSH = DEFAULT_RULES.push;

/** Acceleration of an alien that is awake, px/s2. */
export const ALIEN_PULL = DEFAULT_RULES.alienPull;

/** An alien is awake while its centre is nearer than this to hers, px. */
export const ALIEN_SIGHT = DEFAULT_RULES.alienSight;

/** Speed limit per axis, px/s. */
export const SPEED_LIMIT = DEFAULT_RULES.speedLimit;

// Layout of the state of an `arcade` simulation: one typed array, so that a snapshot is one copy.
export const FRAME = 0;
export const HELD_FRAMES = 1;
export const X = 2;
export const Y = 3;
export const VX = 4;
export const VY = 5;
export const AX = 6;
export const AY = 7;
export const COS = 8;
export const SIN = 9;
export const OUTCOME = 10;
export const TOUCHED = 11;
/** How many things she has collected, as they are counted. */
export const COUNTED = 12;
/** 1 once a chaser has been awake; until then all of them sleep where the level has them. */
export const ROUSED = 13;
/** Number of asteroids that recoil has moved. */
export const MOVED = 14;
/** 1 once an asteroid is farther from its original place, or faster, than neighbourhoods allow for. */
export const STRAYED = 15;
/** 1 if the gun was held in the last frame. */
export const HELD = 16;
/** For a recorder, which reports changes: the last frame's nearest target, or -1, and whether the gun was held. */
export const SEEN_TARGET = 17;
export const SEEN_HELD = 18;
export const HEAD = 19;

// OUTCOME is 0 while the run goes on, then one of these; from COLLIDED on, COLLIDED plus the index of the list of hazards that she
// has touched one of.
export const LOST = 1;
export const BLACK_HOLE = 2;
export const COLLIDED = 3;

/** Limits one axis of a velocity to the speed limit, px/s. */
export const limitSpeed = (v: number, limit: number): number => (v > limit ? limit : v < -limit ? -limit : v);

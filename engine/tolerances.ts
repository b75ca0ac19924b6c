/**
 * What of the method is a choice: how near counts as the same, how small as nothing. Lengths in px, times in s. Each says why it is
 * what it is, and what breaks when it is changed. Choices that concern one file alone stand in that file.
 */

/**
 * Two events nearer than this are the same instant, s for each second of time and at least one second's worth: the rounding of time
 * itself. Smaller, and what falls together by design (a rim that two circles share) happens in an order that rounding decides; larger,
 * and a hazard touched just after the black hole would win over it.
 */
export const SAME_INSTANT = 2e-14;

/**
 * A swing or orbit about the centre smaller than this counts as rest in it, px: it would take more events a second than
 * anybody could wait for, and its velocity is below 3e-3 px/s. Larger, and a release out of a tiny orbit is seen to err.
 */
export const SMALLEST_ORBIT = 1e-7;

/** The same on a line about a centre that stands still, px: there whole periods are skipped. */
export const SMALLEST_SWING = 1e-12;

/**
 * Largest part of the time to the centre that a Taylor piece may reach. The series' singularity lies at the complex time
 * at which u.u = 0, no nearer than she could be at the centre; a pass too close for the last terms to show it must not be
 * stepped over. Near 1 the error of a close pass grows by orders of magnitude.
 */
export const CONVERGENCE = 0.6;

/**
 * How much less than the tolerance a single Taylor piece may err: errors of velocity grow with time, and there are many
 * pieces. At 25,000 the energy of an orbit drifts by less than 1e-12 in an hour at the default tolerance.
 */
export const PIECE_SHARE = 25_000;

/**
 * How far a guard may fall below 0 unseen, px: it is followed with this added to it, so that the search goes on from where it
 * is 0. Below what the way itself errs by; much smaller, and rounding alone holds the search at a guard that touches 0.
 */
export const FLOOR = 1e-12;

/**
 * Surplus at which a thing is taken to matter though it may not yet, px: far above the rounding of any distance in a level. Smaller
 * than rounding, and a contact could be left out of the neighbour list.
 */
export const SURPLUS = 1e-6;

/** What rounding may do to a distance, as a share of it and of what it comes from: a few units of their last digit. */
export const DISTANCE_ROUNDING = 8.9e-16;

/**
 * A line that passes this near to a point passes through it, px: no run could show the difference but by turning the box in no time.
 * Smaller, and a fall that a designer drew straight through a centre misses it by rounding and takes a hundred times the pieces.
 */
export const RADIAL = 1e-12;

/**
 * Likewise for each px of the numbers that a distance comes from, counted from where she starts: nine times the rounding of one of them.
 * Three points that were on a line before their coordinates were rounded to doubles are that near to one.
 */
export const RADIAL_ROUNDING = 1e-15;

/**
 * A dip across the bisector of two asteroids shallower than this is within the error of the way: no change of target, px. Smaller, and
 * between two equally near ones the target changes to and fro in one instant.
 */
export const TIE = 1e-11;

/** The widest tie, px: it grows where the target changes to and fro all the same. */
export const WIDEST_TIE = 1e-4;

/** Rims nearer than this are one to her who slides, px. Smaller, and rounding makes her cross them without end. */
export const SAME_RIM = 1e-9;

/** Two crossings of rims nearer than this come in quick succession, s. */
export const QUICK_CROSSING = 1 / 4000;

/** Where she chatters between rims, one is crossed at most so late, px: then a second of it takes some thousand pieces. */
export const LATEST_CROSSING = 1.28e-7;

/**
 * A bounce on a rim that takes less than this, out and in, counts as sliding, s: it is lower than 1e-6 px, and slower across the rim
 * than 6e-3 px/s. Shorter, and she bounces on without end; longer, and the bounces that are left out are seen.
 */
export const SHORTEST_BOUNCE = 1 / 2000;

/** What lets go of her for a shorter time than this does not let go, s: she would be off a rim by less than 1e-16 px, or gain less than 1e-10 px/s. */
export const SHORTEST_LAPSE = 1e-6;

/** The cubic of a Runge-Kutta step may bend by this much more than the strongest pull, see the drag of the integrators. */
export const CUBIC_BENDS = 5 / 3;

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

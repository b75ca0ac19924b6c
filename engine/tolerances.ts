/**
 * Tolerances of the method: how near counts as the same, and how small as nothing. Lengths are in px, times in s. Each comment
 * gives the reason for a value and what breaks when it is changed. A tolerance that concerns a single file is defined in that
 * file.
 */

/**
 * Two events nearer than this are the same instant: s per second of simulated time, and at least one second's worth. It is the
 * rounding of time itself. If it were smaller, rounding would decide the order of events that coincide by design (a rim that
 * two circles share). If it were larger, a hazard that is touched just after the black hole would win over it.
 */
export const SAME_INSTANT = 2e-14;

/**
 * A swing or orbit about the centre smaller than this counts as rest in the centre, px. It would take more events per second
 * than anyone could wait for, and its velocity is below 3e-3 px/s. If it were larger, the error would be visible after a
 * release from a tiny orbit.
 */
export const SMALLEST_ORBIT = 1e-7;

/** The same on a line about a centre that stands still, px. It can be smaller because whole periods are skipped there. */
export const SMALLEST_SWING = 1e-12;

/**
 * Largest part of the time to the centre that a Taylor piece may cover. The series has its singularity at the complex time at
 * which u.u = 0, which is no nearer than she could be to the centre. A pass so close that the last terms do not show it must
 * not be stepped over. Near 1 the error of a close pass grows by orders of magnitude.
 */
export const CONVERGENCE = 0.6;

/**
 * By how much the error of one Taylor piece must stay below the tolerance: errors of velocity grow with time, and there are
 * many pieces. At 25,000 the energy of an orbit drifts by less than 1e-12 in an hour at the default tolerance.
 */
export const PIECE_SHARE = 25_000;

/** Longest Taylor piece of an accelerated body, s, so that bounds over it stay tight. */
export const LONGEST_TAYLOR = 4;

/**
 * How far a guard may fall below 0 unnoticed, px. It is added to the guard while this is followed, so that a search can
 * continue from a root. It is below the error of the path itself. If it were much smaller, rounding alone would stop the search
 * at a guard that touches 0.
 */
export const FLOOR = 1e-12;

/**
 * Objects that come within this of mattering are treated as if they mattered, px: far above the rounding of any distance in a
 * level. If it were below the rounding, a contact could be missing from the neighbour list.
 */
export const SURPLUS = 1e-6;

/** Relative rounding error of a distance and of the numbers that it is computed from: a few units in the last place. */
export const DISTANCE_ROUNDING = 8.9e-16;

/**
 * A line that passes this near to a point counts as passing through it, px. No run could show the difference, except that the
 * box would turn in no time. If it were smaller, a fall that was drawn straight through a centre would miss it by rounding and
 * take a hundred times the pieces.
 */
export const RADIAL = 1e-12;

/**
 * The same per px of the coordinates that the distance is computed from, counted from her start: nine times the rounding of one
 * of them. Three points that were on a line before their coordinates were rounded to doubles are that near to one.
 */
export const RADIAL_ROUNDING = 1e-15;

/**
 * A fall that comes this near to a centre goes through it, px. On no line at first, since she was all but at rest, she may have
 * no other direction left: pieces that cover only a part of the way to the centre would then never reach it. If it were much
 * larger, a fall past the centre would become one through it.
 */
export const HEAD_ON = 1e-14;

/**
 * A dip across the bisector of two asteroids that is shallower than this is within the error of the path, so the target does
 * not change, px. If it were smaller, the target would alternate between two equally near asteroids in one instant.
 */
export const TIE = 1e-11;

/** The widest tie, px: the tie grows while the target goes on alternating. */
export const WIDEST_TIE = 1e-4;

/**
 * While she slides, rims nearer than this count as one, px. If it were smaller, rounding would make her cross them endlessly.
 */
export const SAME_RIM = 1e-9;

/** Two crossings of rims within this time are in quick succession, s. */
export const QUICK_CROSSING = 1 / 4000;

/**
 * Where she chatters between rims, a crossing is detected at most this late, px. One second of chatter then takes some thousand
 * pieces.
 */
export const LATEST_CROSSING = 1.28e-7;

/**
 * A bounce on a rim that takes less than this, out and in, counts as sliding, s. It is lower than 1e-6 px, and slower across
 * the rim than 6e-3 px/s. If it were shorter, she would bounce endlessly; if it were longer, the omitted bounces would be
 * visible.
 */
export const SHORTEST_BOUNCE = 1 / 2000;

/**
 * A rim that releases her for less than this does not release her, s: she would be off it by less than 1e-16 px, or gain less
 * than 1e-10 px/s.
 */
export const SHORTEST_LAPSE = 1e-6;

/** How much more the cubic of a Runge-Kutta step may bend than the strongest force alone; see `fixed-step.ts` of the integrators. */
export const CUBIC_BENDS = 5 / 3;

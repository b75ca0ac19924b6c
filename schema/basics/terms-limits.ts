/** s; a run has at least one tick of 1/60 s. */
export const SHORTEST_RUN = 0.01;

/** s; the longest run that is ever simulated: one hour, the limit of holds in a level file. */
export const LONGEST_RUN = 3600;

/** The largest work that may be allowed for a level, pieces of motion: counts must stay exact whole numbers. */
export const MOST_WORK = 1e12;

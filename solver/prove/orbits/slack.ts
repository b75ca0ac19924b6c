/** Far more than the rounding error of a step, px and px/s. */
export const SLACK = 1e-6;

/** Far more than the rounding error of an angular momentum, px²/s. */
export const slackL = (L: number): number => 1e-4 + 1e-8 * Math.abs(L);

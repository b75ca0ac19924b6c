/** Limits one axis of a velocity to the speed limit, px/s. */
export const limitSpeed = (v: number, limit: number): number => (v > limit ? limit : v < -limit ? -limit : v);

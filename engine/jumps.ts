/** More than any force can change a path within a tick or two, px. */
const LEAST = 2;

/**
 * Tells whether she was moved from one place to another at once between two states: no flight leads from the first to the
 * second.
 *
 * @param states - states of the astronaut, each beginning with x, y (px), vx, vy (px/s)
 * @param from - index in `states` at which the earlier state begins
 * @param to - index in `states` at which the later state begins
 * @param seconds - time between the two, s; at most a few ticks
 * @returns true if the places differ by more than 2 px from what the velocities allow
 */
export function isJump(states: Float64Array, from: number, to: number, seconds: number): boolean {
  const dx = states[to] - states[from] - ((states[from + 2] + states[to + 2]) / 2) * seconds;
  const dy = states[to + 1] - states[from + 1] - ((states[from + 3] + states[to + 3]) / 2) * seconds;
  return dx * dx + dy * dy > LEAST * LEAST;
}

/** What no force makes of a way within a tick or two, px: more than that she didn't fly. */
const LEAST = 2;

/**
 * Whether she was moved all at once between two states, each x, y, vx, vy from its place on: no flight leads from one to the other.
 * @param seconds time between the two, at most some ticks
 */
export function isJump(states: Float64Array, from: number, to: number, seconds: number): boolean {
  const dx = states[to] - states[from] - ((states[from + 2] + states[to + 2]) / 2) * seconds;
  const dy = states[to + 1] - states[from + 1] - ((states[from + 3] + states[to + 3]) / 2) * seconds;
  return dx * dx + dy * dy > LEAST * LEAST;
}

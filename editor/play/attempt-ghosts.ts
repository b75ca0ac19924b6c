import type { Attempt } from '../attempts/index.ts';
import type { Ghost } from '../context/index.ts';

/** Attempts as ghosts on the canvas. */
export function attemptGhosts(attempts: readonly Attempt[]): Ghost[] {
  return attempts.map(({ number, points }) => ({ id: `attempt-${number}`, label: `attempt ${number}`, points, look: 'attempt' }));
}

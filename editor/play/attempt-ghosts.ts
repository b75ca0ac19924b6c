import type { Ghost } from '../canvas/index.ts';
import type { Attempt } from './attempts.ts';

/** Attempts as the canvas shows them. */
export function attemptGhosts(attempts: readonly Attempt[]): Ghost[] {
  return attempts.map(({ number, points }) => ({ id: `attempt-${number}`, label: `attempt ${number}`, points, look: 'attempt' }));
}

import type { Attempt } from '../../core/attempts/index.ts';
import type { Ghost } from '../../core/context/index.ts';

/** So many attempts are lines on the canvas. */
const SHOWN = 24;

/** The latest attempts as ghosts on the canvas. */
export function attemptGhosts(attempts: readonly Attempt[]): Ghost[] {
  return attempts
    .slice(-SHOWN)
    .map(({ number, points }) => ({ id: `attempt-${number}`, label: `attempt ${number}`, points, look: 'attempt' }));
}

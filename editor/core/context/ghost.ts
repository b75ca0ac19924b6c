import type { Attempt } from '../attempts/index.ts';

/** A path beside that of the run: an attempt, a candidate, a part of the slack fan, an attempt or play that is selected. */
export interface Ghost {
  readonly id: string;
  readonly label: string;
  /** x, y in px, two entries per tick */
  readonly points: Float32Array;
  readonly look: 'attempt' | 'candidate' | 'slack' | 'selected';
}

/** So many attempts are lines on the canvas. */
const SHOWN = 24;

/** The latest attempts as ghosts on the canvas. */
export function attemptGhosts(attempts: readonly Attempt[]): Ghost[] {
  return attempts
    .slice(-SHOWN)
    .map(({ number, points }) => ({ id: `attempt-${number}`, label: `attempt ${number}`, points, look: 'attempt' }));
}

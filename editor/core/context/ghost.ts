import type { StoreApi } from 'zustand/vanilla';
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

/** Replaces the ghosts of one look; those of other looks stay. */
export function putGhosts(ghosts: StoreApi<readonly Ghost[]>, look: Ghost['look'], wanted: readonly Ghost[]): void {
  const now = ghosts.getState();
  const others = now.filter((ghost) => ghost.look !== look);
  if (wanted.length > 0 || others.length < now.length) ghosts.setState([...others, ...wanted], true);
}

import type { Softlocks } from '../../check/index.ts';
import type { Level, SoftlockReport } from '../../schema/index.ts';

/** Where a level is already lost, as reports have it. @param runs those of the level */
export function softlockReport({ states, lasting, places, effort, isFinished }: Softlocks, { runs }: Level): SoftlockReport {
  return {
    states,
    lasting,
    places: places.map(({ x, y, tick, open, alive, states: beyond, run, holds, standing }) => ({
      x,
      y,
      tick,
      open,
      alive,
      states: beyond,
      run: run === null ? null : (runs[run]?.name ?? null),
      holds: holds.map(([press, release]) => [press, release]),
      known: standing.is === 'proved' ? 'proved' : 'not found',
      proof: standing.is === 'proved' ? { code: standing.proof.code, reason: standing.proof.reason } : null,
      searched: standing.is === 'not found' ? standing.ticks : null,
    })),
    effort,
    isFinished,
  };
}

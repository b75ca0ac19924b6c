import { plural } from '../../check/words/index.ts';
import { TICK } from '../../engine/basics/index.ts';
import type { SoftlockReport } from '../../schema/index.ts';

/** At most so many places are listed. */
const MOST = 5;

/** Where a level is already lost, in lines. What is proved and what was merely not found are never put together. */
export function softlockLines({ states, lasting, places, isFinished }: SoftlockReport): string[] {
  const share = (count: number): string => `${count} (${((100 * count) / Math.max(1, states.examined)).toFixed(0)} %)`;
  const head =
    `lost although she lives on: of ${plural(states.examined, 'state')} ${share(lasting.proved)} proved, ` +
    `${share(lasting.notFound)} from which no run was found${isFinished ? '' : '; the effort ended the search'}`;
  const lines = places.slice(0, MOST).map(({ x, y, tick, alive, proof, searched }) => {
    const known = proof === null ? `no run found in ${searched} ticks, which proves nothing` : `proved (${proof.code})`;
    return `  (${Math.round(x)}, ${Math.round(y)}) from ${(tick * TICK).toFixed(2)} s on, alive for ${(alive * TICK).toFixed(1)} s after it: ${known}`;
  });
  return [head, ...lines, ...(places.length > MOST ? [`  and ${places.length - MOST} more: --format json lists them`] : [])];
}

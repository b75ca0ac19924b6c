import { plural } from '../../check/words/index.ts';
import { TICK } from '../../engine/basics/index.ts';
import type { SoftlockReport } from '../../schema/index.ts';

/** At most so many places are listed. */
const MOST = 5;

/** How many of the states are open, lost, about to end, and undecided. What is proved and what was not found stay apart. */
function counts({ states, lasting, isFinished }: SoftlockReport): string {
  const share = (count: number): string => `${count} (${((100 * count) / Math.max(1, states.examined)).toFixed(0)} %)`;
  const soonOver = states.proved - lasting.proved + states.notFound - lasting.notFound;
  return [
    `of ${plural(states.examined, 'state')} ${share(states.open)} open`,
    `lost although she lives on: ${share(lasting.proved)} proved, ${share(lasting.notFound)} from which no run was found`,
    ...(soonOver > 0 ? [`${share(soonOver)} over within a second`] : []),
    ...(states.unknown > 0 ? [`${share(states.unknown)} undecided`] : []),
    ...(isFinished ? [] : ['the effort ended the search']),
  ].join('; ');
}

/** Where a level is already lost, in lines. @param report null: it was not examined */
export function softlockLines(report: SoftlockReport | null): string[] {
  if (report === null) return ['where it is already lost was not examined: no run completes the level'];
  const { places } = report;
  const lines = places.slice(0, MOST).map(({ x, y, tick, alive, proof, searched }) => {
    const known = proof === null ? `no run found in ${searched} ticks, which proves nothing` : `proved (${proof.code})`;
    return `  (${Math.round(x)}, ${Math.round(y)}) from ${(tick * TICK).toFixed(2)} s on, alive for ${(alive * TICK).toFixed(1)} s after it: ${known}`;
  });
  return [
    counts(report),
    ...lines,
    ...(places.length > MOST ? [`  and ${places.length - MOST} more: --format json lists them`] : []),
  ];
}

import type { Found } from './rounds.ts';

/** The progress of a search in one line. */
export function progressText({ solutions, effort, closest }: Found, seconds: number): string {
  const so = `solving, ${seconds.toFixed(0)} s, ${(effort.ticks / 1e6).toFixed(1)} million ticks: `;
  const [best] = solutions;
  if (best === undefined) {
    return `${so}no run yet${closest === null ? '' : `, closest ${closest.distance.toFixed(1)} px`}; Ctrl-C ends`;
  }
  const presses = `${best.holds.length} ${best.holds.length === 1 ? 'press' : 'presses'}`;
  const p40 = best.p40 === null ? '' : `, success at 40 ms ${(100 * best.p40.p).toFixed(0)} %`;
  return `${so}${best.time.toFixed(2)} s, ${presses}${p40}; Ctrl-C drops it`;
}

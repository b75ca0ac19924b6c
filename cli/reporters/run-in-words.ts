import { bodyInWords, countMinerals, plural } from '../../check/words/index.ts';
import type { CheckedLevel } from '../check/index.ts';

/** The run that completes a level, in words: time, minerals, clearance; empty if there is none. */
export function runInWords({ verdict, run, found, mineralCount }: CheckedLevel): string[] {
  if (verdict !== 'completable' || run === null) return [];
  const minerals = mineralCount === 0 ? 'no minerals' : `${countMinerals(run)} of ${plural(mineralCount, 'mineral')}`;
  const near = run.clearance;
  const clearance = near === null ? 'nothing deadly' : `${near.distance.toFixed(1)} px clear of ${bodyInWords(near)}`;
  return [`${run.time.toFixed(2)} s`, minerals, found === null ? clearance : `${clearance}, in a run that a search found`];
}

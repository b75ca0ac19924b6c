import { TICK } from '../../../engine/index.ts';
import type { Loss } from '../../workers/index.ts';

const seconds = (ticks: number): string => `${(ticks * TICK).toFixed(2)} s`;

/**
 * Since when a run was lost, to follow its name: `lost from 2.35 s on (proved)`. What is proved and what is only not found are
 * told apart. null: nothing is known yet, or the run completes the level.
 */
export function sinceInWords({ lost, proved, completes, open, last }: Loss): string | null {
  if (completes) return null;
  // nothing decides for the end itself within a few ticks
  if (lost === null) return open !== null && open >= last ? 'not lost until it ends' : null;
  if (proved === null) return `no run found from ${seconds(lost.tick)} on, which proves nothing`;
  const from = `lost from ${seconds(proved.tick)} on (proved)`;
  return proved.tick > lost.tick ? `${from}, no run found from ${seconds(lost.tick)} on` : from;
}

/** The same with the end: `lost from 2.35 s on (proved), ends at 4.10 s`. @param end of the run, s */
export function lossInWords(loss: Loss, end: number): string | null {
  const since = sinceInWords(loss);
  return since === null ? null : `${since}; ends at ${end.toFixed(2)} s`;
}

/** The same in a few words: `lost from 2.35 s, ends at 4.10 s`. @param end of the run, s */
export function briefLossInWords(loss: Loss, end: number): string | null {
  const from = lostFromInWords(loss);
  return from === null ? null : `${from}, ends at ${end.toFixed(2)} s`;
}

/** The beginning of the loss in a few words, for a mark: `lost from 2.35 s`, `no run found from 2.35 s`. */
export function lostFromInWords({ lost, proved }: Pick<Loss, 'lost' | 'proved'>): string | null {
  if (proved !== null) return `lost from ${seconds(proved.tick)}`;
  return lost === null ? null : `no run found from ${seconds(lost.tick)}`;
}

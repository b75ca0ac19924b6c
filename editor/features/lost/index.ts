import { createStore } from 'zustand/vanilla';
import { type AccuracyName, TICK } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { ofDocument } from '../../core/kept/index.ts';
import type { Losing, Loss } from '../../workers/index.ts';

/** What is known of where the open level is already lost. */
export interface LostFindings {
  /**
   * `off`: not asked for. `waiting`: the level has just changed. `needs a run`: no run completes the level, so everything could be
   * lost. `done`: the effort is spent or nothing is left to examine.
   */
  readonly phase: 'off' | 'waiting' | 'needs a run' | 'examining' | 'done' | 'stopped' | 'failed';
  /** Why it failed; null: it did not. */
  readonly message: string | null;
  readonly losing: Losing | null;
  /** Since when runs were lost that fail, by {@link lossKey}. */
  readonly losses: ReadonlyMap<string, Loss>;
  /** The effort for the states, ticks. */
  readonly effort: number;
}

/** Nothing is known, with this effort for what is to come. */
export const NOTHING_LOST = { message: null, losing: null, losses: new Map<string, Loss>() } as const;

/** What a run is known by: its effective holds, and the accuracy with which it was played. */
export const lossKey = (holds: readonly Hold[], accuracy: AccuracyName): string => `${accuracy} ${holds.join()}`;

/** What is known of where a level is already lost. */
export const lostOf = ofDocument(() => createStore<LostFindings>(() => ({ phase: 'off', effort: 0, ...NOTHING_LOST })));

const plural = (count: number, what: string): string => `${count} ${what}${count === 1 ? '' : 's'}`;

// in words: where the level is lost

/** How many lost states after which she lives on are known, apart: proved, and from which no run was found. */
export function countLost({ losing }: Pick<LostFindings, 'losing'>): { readonly proved: number; readonly notFound: number } {
  const states = losing?.states ?? [];
  const proved = states.filter(({ known }) => known === 'proved').length;
  return { proved, notFound: states.length - proved };
}

/** What is known, as one or two sentences. What is proved and what was only not found are never added up. */
export function lostInWords(findings: LostFindings): string {
  const { phase, losing, message } = findings;
  if (phase === 'off') return '';
  if (phase === 'waiting') return 'Waits until the level is at rest.';
  if (phase === 'needs a run') return 'No run completes the level yet, so nothing is known to be lost. Solve may find one.';
  if (phase === 'failed') return `Failed: ${message}. Hide and show the lost states to try again.`;
  if (phase === 'examining') return 'Examining where the level is already lost…';
  if (losing === null) return 'Stopped before anything was found.';
  const { proved, notFound } = countLost(findings);
  const { examined, open } = losing.counts;
  const lost =
    proved + notFound === 0
      ? 'none is known to be lost while she lives on'
      : `${proved} are proved lost although she lives on; from ${notFound} no run was found, which proves nothing`;
  return `${phase === 'stopped' ? 'Stopped. ' : ''}Of ${plural(examined, 'state')} ${open} can still reach the black hole, ${lost}.`;
}

const seconds = (ticks: number): string => `${(ticks * TICK).toFixed(2)} s`;

// in words: since when a run was lost

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

import { closestInWords } from '../../../check/words/index.ts';
import { mineralsNeeded } from '../../../solver/index.ts';
import { pixels, plural } from '../../core/figures/index.ts';
import type { SearchState } from './search-session.ts';
import { goalOf, type SearchSettings } from './search-task.ts';

/** The state of a search in words. */
export interface SearchSummary {
  readonly tone: 'good' | 'warn' | 'bad' | 'plain';
  readonly text: string;
  /** A note below the list of runs: text above the list would move it under the pointer. */
  readonly note: string | null;
}

/** What the level's own runs achieve. */
export interface OwnRuns {
  /** A run that meets the goal; null if none is known. */
  readonly meets: string | null;
  /** A run that reaches the black hole, with or without minerals; null if none is known. */
  readonly completes: string | null;
}

/** The goal besides the black hole: ` with all 3 minerals`; '' if minerals do not matter. @param count minerals in the level */
export function askedInWords(settings: SearchSettings, count: number): string {
  const goal = goalOf(settings, count);
  if (goal.minerals === 'any') return '';
  const needed = mineralsNeeded(goal, count);
  if (needed < count) return ` with at least ${needed} of ${count} minerals`;
  return count === 1 ? ' with the mineral' : ` with all ${count} minerals`;
}

/** What holds whatever the search finds. */
function ownInWords({ meets, completes }: OwnRuns, asked: string): string {
  if (meets !== null) return ` The level's own run “${meets}” already does this.`;
  return asked !== '' && completes !== null
    ? ` The level is completable all the same: its run “${completes}” reaches the black hole.`
    : '';
}

/** How near the search came to the black hole; if it reached it, why that does not count. */
function nearInWords({ solving }: SearchState, asked: string): string {
  const closest = solving?.closest ?? null;
  if (closest === null) return '';
  if (closest.distance > 0) return ` The closest approach, shown on the canvas, was ${closestInWords(closest, pixels)}.`;
  return asked === ''
    ? ' It reached the black hole, but had no time to confirm the run from the start.'
    : ` It reached the black hole, but not${asked}.`;
}

/** Why the search ended, as the beginning of a sentence. */
function endInWords({ phase, settings, ms, solving }: SearchState): string {
  if (phase === 'cancelled') return `Stopped after ${(ms / 1000).toFixed(1)} s`;
  if (solving?.finished === true) return 'Nothing is left to try';
  return `The ${settings?.budget ?? 0} s are over`;
}

/** @param wanted number of different runs that are searched for */
function foundInWords(state: SearchState, asked: string, wanted: number): SearchSummary {
  const { phase, found, solving, isOld } = state;
  if (isOld) {
    const working = found.filter(({ works }) => works).length;
    const text = `${working} of ${plural(found.length, 'run')} found before the level changed still work${working === 1 ? 's' : ''}${asked}.`;
    return { tone: working > 0 ? 'good' : 'warn', text, note: null };
  }
  const text = `${plural(found.length, 'different run', 'different runs')} found${phase === 'running' ? ' so far' : ''}`;
  const looked = `Looked for up to ${wanted} runs${asked}`;
  if (phase === 'running' || found.length >= wanted) return { tone: 'good', text, note: `${looked}.` };
  const more = solving?.finished === true ? '' : ' More time or another seed may find more.';
  return { tone: 'good', text, note: `${looked}. ${endInWords(state)}.${more}` };
}

/**
 * The state of a search in a sentence or two: the goal, what was found, and what it means if nothing was.
 * @param count minerals in the level
 * @param wanted number of different runs that are searched for
 */
export function summaryOf(state: SearchState, own: OwnRuns, count: number, wanted: number): SearchSummary {
  const { phase, found, impossible, isHopeless, isOld, message, settings } = state;
  const asked = settings === null ? '' : askedInWords(settings, count);
  const withTone = (tone: SearchSummary['tone'], text: string): SearchSummary => ({ tone, text, note: null });
  if (impossible !== null) return withTone('bad', `Proved impossible: ${impossible.reason}.`);
  if (isHopeless && found.length === 0)
    return withTone('bad', `Proved: no run completes the level${asked}.${ownInWords(own, asked)}`);
  if (phase === 'failed') return withTone('bad', `The search failed: ${message}. Start it again; the level is unchanged.`);
  const stopped = phase === 'stale' ? 'The level changed, so the search stopped. ' : '';
  if (found.length > 0) {
    const summary = foundInWords(state, asked, wanted);
    return { ...summary, text: stopped + summary.text };
  }
  if (isOld) {
    const before = `The level has changed since the search, which found no run${asked}. `;
    return withTone('plain', `${stopped === '' ? before : stopped}Solve searches the current level.`);
  }
  const near = nearInWords(state, asked);
  if (phase === 'running') return withTone('plain', `Looking for runs${asked}: none found yet.${near}${ownInWords(own, asked)}`);
  const end = endInWords(state);
  if (own.meets !== null) return withTone('plain', `${end}: no other run${asked} was found.${near}${ownInWords(own, asked)}`);
  const meaning = ' This does not prove that there is none.';
  return withTone('warn', `${end}: no run into the black hole${asked} was found.${meaning}${near}${ownInWords(own, asked)}`);
}

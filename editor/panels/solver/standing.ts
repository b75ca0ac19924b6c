import { closestInWords } from '../../../check/words/index.ts';
import { mineralsNeeded } from '../../../solver/index.ts';
import { inPageWords } from '../../document/index.ts';
import { pixels, plural } from '../figures/index.ts';
import { goalOf, type SearchSettings } from './search-settings.ts';
import type { SearchState } from './search-state.ts';

/** How a search stands, for people. */
export interface Standing {
  readonly tone: 'good' | 'warn' | 'bad' | 'plain';
  readonly text: string;
  /** What else is to be said, below the ways found: what is above them must not push them away under the pointer. */
  readonly note: string | null;
}

/** What the level's own runs show already. */
export interface OwnRuns {
  /** One that does what is asked; null: none is known to. */
  readonly meets: string | null;
  /** One that reaches the black hole, whatever it takes; null: none is known to. */
  readonly completes: string | null;
}

/** What is asked of a run besides the black hole: ` with all 3 minerals`; '' where minerals do not matter. @param count minerals in the level */
export function askedInWords(settings: SearchSettings, count: number): string {
  const goal = goalOf(settings, count);
  if (goal.minerals === 'any') return '';
  const needed = mineralsNeeded(goal, count);
  if (needed < count) return ` with at least ${needed} of ${count} minerals`;
  return count === 1 ? ' with the mineral' : ` with all ${count} minerals`;
}

/** What is so already, whatever the search finds. */
function ownInWords({ meets, completes }: OwnRuns, asked: string): string {
  if (meets !== null) return ` The level's own run “${meets}” does it already.`;
  return asked !== '' && completes !== null
    ? ` The level is completable all the same: its run “${completes}” reaches the black hole.`
    : '';
}

/** How near it came; where that was all the way, why it does not count. */
function nearInWords({ solving }: SearchState, asked: string): string {
  const closest = solving?.closest ?? null;
  if (closest === null) return '';
  if (closest.distance > 0) return ` The closest approach, shown on the canvas, was ${closestInWords(closest, pixels)}.`;
  return asked === ''
    ? ' It has reached the black hole, but no run was ready and replayed from the start by then.'
    : ` It has reached the black hole, but not${asked}.`;
}

/** Why a search that is over is over, as the beginning of a sentence. */
function endInWords({ phase, settings, ms, solving }: SearchState): string {
  if (phase === 'cancelled') return `Stopped by hand after ${(ms / 1000).toFixed(1)} s`;
  if (solving?.finished === true) return 'Nothing is left to try';
  return `The ${settings?.budget ?? 0} s are over`;
}

/** @param wanted different ways that are looked for */
function foundInWords(state: SearchState, asked: string, wanted: number): Standing {
  const { phase, found, solving, isOld } = state;
  if (isOld) {
    const working = found.filter(({ works }) => works).length;
    const text = `Of ${plural(found.length, 'way')} found before the level changed ${working} still work${working === 1 ? 's' : ''}${asked}.`;
    return { tone: working > 0 ? 'good' : 'warn', text, note: null };
  }
  const text = `${plural(found.length, 'different way', 'different ways')} found${phase === 'running' ? ' so far' : ''}`;
  const looked = `Looked for up to ${wanted} ways${asked}`;
  if (phase === 'running' || found.length >= wanted) return { tone: 'good', text, note: `${looked}.` };
  const more = solving?.finished === true ? '' : ' More time or another seed may find more.';
  return { tone: 'good', text, note: `${looked}. ${endInWords(state)}.${more}` };
}

/**
 * How a search stands, in a sentence or two: what was asked, what was found, what it means where nothing was.
 * @param count minerals in the level
 * @param wanted different ways that are looked for
 */
export function standingOf(state: SearchState, own: OwnRuns, count: number, wanted: number): Standing {
  const { phase, found, impossible, isHopeless, isOld, message, settings } = state;
  const asked = settings === null ? '' : askedInWords(settings, count);
  const withTone = (tone: Standing['tone'], text: string): Standing => ({ tone, text, note: null });
  if (impossible !== null) return withTone('bad', `Proved impossible: ${inPageWords(impossible.reason)}.`);
  if (isHopeless && found.length === 0)
    return withTone('bad', `Proved: no run completes the level${asked}.${ownInWords(own, asked)}`);
  if (phase === 'failed') return withTone('bad', `The search broke down: ${message}. Start it again; the level is untouched.`);
  const stopped = phase === 'stale' ? 'The level changed, so the search stopped. ' : '';
  if (found.length > 0) {
    const standing = foundInWords(state, asked, wanted);
    return { ...standing, text: stopped + standing.text };
  }
  if (isOld) {
    const before = `The level has changed since it was searched; no run${asked} was found in it as it was. `;
    return withTone('plain', `${stopped === '' ? before : stopped}Solve looks in the level as it is now.`);
  }
  const near = nearInWords(state, asked);
  if (phase === 'running') return withTone('plain', `Looking for runs${asked}: none found yet.${near}${ownInWords(own, asked)}`);
  const end = endInWords(state);
  if (own.meets !== null) return withTone('plain', `${end}: no other run${asked} was found.${near}${ownInWords(own, asked)}`);
  const meaning = ' That does not prove that there is none.';
  return withTone('warn', `${end}: no run into the black hole${asked} was found.${meaning}${near}${ownInWords(own, asked)}`);
}

import { TICK } from '../../engine/index.ts';
import { plural } from '../words/index.ts';
import type { HoldPair, RunsDifference } from './compare-runs.ts';
import type { Partings } from './distances.ts';

/** `3 ticks later`, `as early` */
export const shiftInWords = (ticks: number): string =>
  ticks === 0 ? 'at the same tick' : `${plural(Math.abs(ticks), 'tick')} ${ticks > 0 ? 'later' : 'earlier'}`;

/** A pair of holds in words. @param names of both runs */
export function pairInWords({ one, other, press, release }: HoldPair, names: readonly [one: string, other: string]): string {
  if (one === null || other === null) return `only in ${one === null ? names[1] : names[0]}`;
  if (press === 0 && release === 0) return 'the same';
  if (press === release && press !== null) return `${shiftInWords(press)} as a whole`;
  return `press ${shiftInWords(press ?? 0)}, release ${shiftInWords(release ?? 0)}`;
}

const at = (tick: number): string => `tick ${tick} (${(tick * TICK).toFixed(2)} s)`;

/** Meetings that are named; more are counted. */
const MOST = 3;

/** Where two runs part and meet, in sentences. @param partings null: not known yet */
export function partingsInWords({ from }: Pick<RunsDifference, 'from'>, partings: Partings | null): string {
  if (from === null) return 'Both press and release at the same ticks.';
  const scripts = `Their holds differ from ${at(from)} on.`;
  if (partings === null) return scripts;
  const { parts, meets } = partings;
  if (parts === null) return `${scripts} They are never more than 1 px apart while both last.`;
  const ways = `They are more than 1 px apart from ${at(parts)} on`;
  if (meets.length === 0) return `${scripts} ${ways}, and do not meet again.`;
  const named = meets.slice(0, MOST).map(({ tick, distance }) => `${distance.toFixed(1)} px at ${at(tick)}`);
  const more = meets.length > MOST ? ` and ${meets.length - MOST} times more` : '';
  return `${scripts} ${ways}, and come near each other again: ${named.join(', ')}${more}.`;
}

import { bodyInWords, countMinerals, plural } from '../../check/words/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { visibleLine } from '../terminal/index.ts';
import type { Results } from './reporter.ts';

/** The files that a report for people names at most. */
const MOST_NAMED = 20;

/**
 * What was not checked, for people: lines, or nothing if all was checked. No line begins with a file, whose name GitHub could take
 * for a command.
 */
export function earlyEndInWords({ unchecked, interrupted, unlisted }: Results): string {
  const words = unlistedInWords({ unlisted });
  const rest = words === '' ? '' : `${words}\n`;
  if (unchecked.length === 0) return interrupted ? 'interrupted by a signal after the last level\n' : rest;
  const why = interrupted ? 'interrupted by a signal' : 'ended early';
  const are = unchecked.length === 1 ? 'is' : 'are';
  const named = unchecked.slice(0, MOST_NAMED).map((file) => `  - ${visibleLine(file)}\n`);
  const more = unchecked.length > MOST_NAMED ? `  - and ${unchecked.length - MOST_NAMED} more\n` : '';
  return `${why}: ${plural(unchecked.length, 'level')} ${are} not checked:\n${named.join('')}${more}`;
}

/** The levels of a large set that fail and that a report does not list; '' if there are none. */
export const unlistedInWords = ({ unlisted = 0 }: Pick<Results, 'unlisted'>): string =>
  unlisted === 0
    ? ''
    : `and ${plural(unlisted, 'level')} more that ${unlisted === 1 ? 'fails' : 'fail'}: --format json lists all levels`;

/** The run that completes a level, in words: time, minerals, clearance; empty if there is none. */
export function runInWords({ verdict, run, found, mineralCount }: CheckedLevel): string[] {
  if (verdict !== 'completable' || run === null) return [];
  const minerals = mineralCount === 0 ? 'no minerals' : `${countMinerals(run)} of ${plural(mineralCount, 'mineral')}`;
  const near = run.clearance;
  const clearance = near === null ? 'nothing deadly' : `${near.distance.toFixed(1)} px clear of ${bodyInWords(near)}`;
  return [`${run.time.toFixed(2)} s`, minerals, found === null ? clearance : `${clearance}, in a run that a search found`];
}

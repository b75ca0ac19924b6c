import { outcomeAsPredicate, plural } from '../../../check/words/index.ts';
import type { StandingRun, VersionStanding } from '../standing.ts';
import { numbersApart, quoted } from './values.ts';

/** Smaller differences of time are not mentioned, s. */
const SHORTEST = 0.005;
/** Smaller differences of distance are not mentioned, px. */
const NEAREST = 0.05;

/**
 * What the changes of a level lead to: `slack 5 -> 2 ticks`, `0.3 s slower`; empty if all is as before.
 * @param range range of the later version, px
 */
export function effectsInWords(before: VersionStanding, after: VersionStanding, range: number): string[] {
  const words: string[] = [];
  const [b, a] = [before.run, after.run];
  const isDone = after.verdict === 'completable';
  if (before.verdict !== after.verdict) words.push(`${before.verdict} -> ${after.verdict}`);
  if (a === null) return words;
  const end = outcomeAsPredicate(a, range);
  if (!isDone) {
    // what a failing run does matters if it did something else before
    const isNew = b === null || b.name !== a.name || outcomeAsPredicate(b, range) !== end;
    if (isNew) words.push(`run ${quoted(a.name)} ${b === null ? end : sinceNow(end)}`);
    return words;
  }
  if (before.verdict !== 'completable' || b === null) return [...words, `run ${quoted(a.name)} ${end}`];
  if (b.name !== a.name) words.push(`completed by run ${quoted(a.name)} instead of run ${quoted(b.name)}`);
  words.push(...slackInWords(b, a));
  const later = a.time - b.time;
  if (Math.abs(later) >= SHORTEST) words.push(`${secondsInWords(Math.abs(later))} ${later > 0 ? 'slower' : 'faster'}`);
  if (a.minerals !== b.minerals || before.mineralCount !== after.mineralCount) {
    const of = (run: StandingRun, { mineralCount }: VersionStanding) => `${run.minerals} of ${mineralCount}`;
    words.push(`${of(b, before)} -> ${of(a, after)} minerals`);
  }
  if (b.clearance !== null && a.clearance !== null && Math.abs(a.clearance - b.clearance) >= NEAREST) {
    const [old, now] = [b.clearance, a.clearance].map((px) => Number(px.toFixed(1)) + 0);
    const [oldWords, nowWords] = old === now ? numbersApart(b.clearance, a.clearance) : [String(old), String(now)];
    words.push(`clearance ${oldWords} -> ${nowWords} px`);
  }
  return words;
}

function slackInWords(before: StandingRun, after: StandingRun): string[] {
  const [b, a] = [before.slack?.smallestWindow ?? null, after.slack?.smallestWindow ?? null];
  return b === null || a === null || b === a ? [] : [`slack ${b} -> ${plural(a, 'tick')}`];
}

const secondsInWords = (seconds: number): string =>
  seconds < 0.01 ? 'less than 0.01 s' : `${Number(seconds.toFixed(seconds < 0.1 ? 2 : 1))} s`;

/** What is true of a level, for one that was added or removed: `completable in 7.12 s, 2 of 3 minerals, slack 4 ticks`. */
export function standingInWords({ verdict, mineralCount, run }: VersionStanding, range: number): string {
  if (run === null) return verdict;
  if (verdict !== 'completable') return `${verdict}: run ${quoted(run.name)} ${outcomeAsPredicate(run, range)}`;
  const words = [`completable in ${run.time.toFixed(2)} s`];
  if (mineralCount > 0) words.push(`${run.minerals} of ${plural(mineralCount, 'mineral')}`);
  const slack = run.slack?.smallestWindow ?? null;
  if (slack !== null) words.push(`slack ${plural(slack, 'tick')}`);
  return words.join(', ');
}

/** `dies` becomes `now dies`, and `is lost` `is now lost`. */
const sinceNow = (end: string): string => (end.startsWith('is ') ? `is now ${end.slice(3)}` : `now ${end}`);

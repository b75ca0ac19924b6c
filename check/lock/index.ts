import { isSame, type LockEntry, type OwnRules, RULE_NAMES, rulesOf } from '../../schema/index.ts';
import { plural } from '../words/index.ts';

/** A difference between two results of a level. */
interface ResultChange {
  /** What differs, in words: `completed at tick 412, before 398; 2 of 3 minerals, before 3`. */
  readonly words: string;
  /** Which rules differ, in words: `pull 42, before 39`; '' when none does. */
  readonly rules: string;
}

/**
 * Compares the result of a level with the one that was agreed on. Other rules alone are no difference: only what they change is.
 * @param now the result now
 * @param before the result that was agreed on
 * @returns what differs; null when nothing does
 */
export function resultChange(now: LockEntry, before: LockEntry): ResultChange | null {
  const parts = [
    limitsChange(now, before),
    verdictChange(now, before),
    endChange(now, before),
    mineralChange(now, before),
    ticksChange(now, before),
  ];
  const words = parts.filter((part) => part !== '');
  if (words.length === 0 && now.hash === before.hash) return null;
  if (words.length === 0) words.push(hashChange(now, before));
  return { words: words.join('; '), rules: rulesChange(now.rules, before.rules) };
}

/** Whether a lock need not be written anew for a level. */
export const isAgreed = (now: LockEntry, before: LockEntry): boolean => isSame(now, before);

/**
 * What differs between two entries of a lock, for the report of an update.
 * @param now the new entry
 * @param before the old entry
 * @returns what differs, in words
 */
export function entryChange(now: LockEntry, before: LockEntry): string {
  const change = resultChange(now, before);
  const accuracy = now.accuracy === before.accuracy ? '' : `accuracy ${now.accuracy}, before ${before.accuracy}`;
  const rules = rulesChange(now.rules, before.rules);
  return [change?.words ?? '', accuracy, rules === '' ? '' : `rules: ${rules}`].filter((part) => part !== '').join('; ');
}

/** Other limits are a difference even where the result is the same: it was agreed on under these. */
function limitsChange(now: LockEntry, before: LockEntry): string {
  const usual = 'the usual limit';
  const seconds = ({ maxTime }: LockEntry): string => (maxTime === undefined ? usual : `${maxTime} s`);
  const pieces = ({ maxWork }: LockEntry): string => (maxWork === undefined ? usual : `${maxWork} pieces of motion`);
  return [
    ...(now.maxTime === before.maxTime ? [] : [`time limit ${seconds(now)}, before ${seconds(before)}`]),
    ...(now.maxWork === before.maxWork ? [] : [`work limit ${pieces(now)}, before ${pieces(before)}`]),
  ].join('; ');
}

const verdictChange = (now: LockEntry, before: LockEntry): string =>
  now.verdict === before.verdict ? '' : `${now.verdict}, before ${before.verdict}`;

const endInWords = ({ outcome, tick }: LockEntry): string => `${outcome} at tick ${tick}`;

function endChange(now: LockEntry, before: LockEntry): string {
  if (now.outcome === before.outcome && now.tick === before.tick) return '';
  if (now.outcome === undefined) return `no run was played, before ${endInWords(before)}`;
  if (before.outcome === undefined) return `${endInWords(now)}, before no run was played`;
  return `${endInWords(now)}, before ${now.outcome === before.outcome ? before.tick : endInWords(before)}`;
}

const mineralsInWords = ({ minerals, mineralCount }: LockEntry): string =>
  `${minerals ?? 0} of ${plural(mineralCount ?? 0, 'mineral')}`;

function mineralChange(now: LockEntry, before: LockEntry): string {
  if (now.minerals === before.minerals && now.mineralCount === before.mineralCount) return '';
  // said with the run
  if (now.minerals === undefined || before.minerals === undefined) return '';
  return `${mineralsInWords(now)}, before ${now.mineralCount === before.mineralCount ? before.minerals : mineralsInWords(before)}`;
}

function ticksChange(now: LockEntry, before: LockEntry): string {
  if (now.certifiedTicks === before.certifiedTicks) return '';
  const inWords = (ticks: number | undefined): string => (ticks === undefined ? 'none' : String(ticks));
  return `certified ticks ${inWords(now.certifiedTicks)}, before ${inWords(before.certifiedTicks)}`;
}

function hashChange(now: LockEntry, before: LockEntry): string {
  if (now.hash === undefined || before.hash === undefined) return `hash ${now.hash ?? 'none'}, before ${before.hash ?? 'none'}`;
  return `the same end by another motion: hash ${now.hash}, before ${before.hash}`;
}

function rulesChange(now: OwnRules | undefined, before: OwnRules | undefined): string {
  const [a, b] = [rulesOf({ rules: now }), rulesOf({ rules: before })];
  return RULE_NAMES.filter((name) => a[name] !== b[name])
    .map((name) => `${name} ${a[name]}, before ${b[name]}`)
    .join(', ');
}

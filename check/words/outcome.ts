import { effectEventInWords, type Outcome, type Run, type RunEvent, type Touched } from '../../engine/index.ts';
import { objectName, touchedName } from '../../schema/basics/index.ts';
import type { Verdict } from '../../schema/index.ts';

/** How a run ended. */
export interface RunEnd {
  /** The outcome. */
  readonly outcome: Outcome;
  /** The object that she touched; null when there is none. */
  readonly with: Touched | null;
  /** The end of the run, s from the start. */
  readonly time: number;
  /** The tick of 1/60 s in which it ended. */
  readonly tick: number;
}

/** Names an object: `nova 2`, `the black hole`. */
export const bodyInWords = ({ kind, index }: Touched): string => touchedName(kind, index);

const touchedInWords = (touched: Touched | null): string => (touched === null ? 'something' : bodyInWords(touched));

/**
 * How a run ended, for a report: `collided with nova 2 at 3.217 s (tick 193)`.
 * @param range range of the level, px
 */
export function outcomeInWords(end: RunEnd, range: number): string {
  const when = `at ${end.time.toFixed(3)} s (tick ${end.tick})`;
  switch (end.outcome) {
    case 'completed':
      return `completed ${when}`;
    case 'collided':
      return `collided with ${touchedInWords(end.with)} ${when}`;
    case 'lost':
      return `lost ${when}: farther than ${range} px from every asteroid`;
    case 'timeout':
      return `not over after ${Number(end.time.toFixed(3))} s`;
  }
}

/**
 * How a run ended, as the predicate of a sentence about her or the run: `collides with nova 3 at 3.22 s`.
 * @param range range of the level, px
 */
export function outcomeAsPredicate(end: Omit<RunEnd, 'tick'>, range: number): string {
  const when = `at ${end.time.toFixed(2)} s`;
  switch (end.outcome) {
    case 'completed':
      return `reaches the black hole ${when}`;
    case 'collided':
      return `collides with ${touchedInWords(end.with)} ${when}`;
    case 'lost':
      return `is lost ${when}, farther than ${range} px from every asteroid`;
    case 'timeout':
      return `is not over after ${end.time} s`;
  }
}

/**
 * Why a run failed, in a few words for the place where it did: `hits nova 3`; null when it completed the level.
 * @param range range of the level, px
 */
export function reasonInWords(end: RunEnd, range: number): string | null {
  switch (end.outcome) {
    case 'completed':
      return null;
    case 'collided':
      return `hits ${touchedInWords(end.with)}`;
    case 'lost':
      return `lost: farther than ${range} px from every asteroid`;
    case 'timeout':
      return `not over after ${end.time} s`;
  }
}

/** How many different minerals a run collected. Each counts once, although `arcade` may count one twice. */
export const countMinerals = (run: Pick<Run, 'minerals'>): number => new Set(run.minerals.map(({ index }) => index)).size;

/** The meaning of each verdict that needs attention, as the beginning of a sentence. */
export const VERDICT_MEANS: Readonly<Record<Exclude<Verdict, 'completable'>, string>> = {
  broken: 'none of its runs completes the level',
  unproven: 'nothing shows that it can be completed',
  impossible: 'it is proved that nobody can complete it',
  invalid: 'the file is not a valid level',
  crashed: 'gq itself failed on it',
};

/** What happens in a run, in words: `target: asteroid 2`. */
export function eventInWords(event: RunEvent): string {
  switch (event.type) {
    case 'press':
    case 'release':
      return event.type;
    case 'target':
      return `target: ${objectName('asteroid', event.index)}`;
    case 'mineral':
      return `${objectName('mineral', event.index)} collected`;
    case 'enter':
    case 'leave':
      return `${event.type}s the field of ${objectName('repulsor', event.index)}`;
    case 'effect':
      return effectEventInWords(event);
    case 'wake':
      return `${objectName('alien', event.index)} wakes`;
    case 'sleep':
      return `${objectName('alien', event.index)} falls asleep`;
    case 'explosion':
      return `${event.aliens.map((index) => objectName('alien', index)).join(' and ')} explode`;
    case 'completed':
    case 'collided':
    case 'lost':
      return event.with === null ? event.type : `${event.type}: touches ${bodyInWords(event.with)}`;
  }
}

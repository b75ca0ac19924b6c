import type { Level } from '../../schema/index.ts';

/** What of a level the page has not played, since it would have been kept too busy. A worker plays it all. */
export type Limit =
  /** The person wants nothing played. */
  | 'unchecked'
  /** Nothing: its very start takes too much work. */
  | 'everything'
  /** The shown run, from the end of its way on. */
  | 'run'
  /** The shown run is whole; other runs may complete the level. */
  | 'others';

/** So long the page may be kept by one answer while something is dragged, ms: the hand sees ten of them a second. */
export const WHILE_DRAGGED = 60;
/** And once it has come to rest. */
export const AT_REST = 400;

/** Pieces of motion that the page plays for one answer: within a single tick, too, where nobody looks at the clock. */
export const MOST_WORK = 50_000;

/** The level without what makes it slow: for whoever shows a level that is not played. */
export const bareOf = (level: Level): Level => ({
  ...level,
  asteroids: [],
  novae: [],
  repulsors: [],
  aliens: [],
  minerals: [],
  runs: [],
});

/** Why a level is not played to its end, for people. */
export function limitInWords(limit: Limit): string {
  switch (limit) {
    case 'unchecked':
      return 'not played: checks are off for this level';
    case 'everything':
      return 'work limit: the level takes too much work to be played while it is edited';
    case 'run':
      return 'work limit: the run takes too much work to be played to its end while it is edited';
    case 'others':
      return 'work limit: not all runs of the level could be played while it is edited';
  }
}

import type { Level } from '../../../schema/index.ts';

/** What the page did not simulate of a level, to stay responsive. A worker simulates all of it. */
export type Limit =
  /** checks are off: nothing is simulated */
  | 'unchecked'
  /** nothing: even the start takes too much work */
  | 'everything'
  /** the shown run from the end of its trajectory on */
  | 'run'
  /** other runs, which may complete the level; the shown run is complete */
  | 'others';

/** ms that an answer may block the page during a drag: the user sees ten or more updates per second */
export const WHILE_DRAGGED = 60;
/** the same once the level is at rest */
export const AT_REST = 400;

/** pieces of motion that the page simulates per answer; also limits the work within a tick, where the clock is not read */
export const MOST_WORK = 50_000;

/** The level without everything that makes it slow, to show a level that is not simulated. */
export const bareOf = (level: Level): Level => ({
  ...level,
  asteroids: [],
  novae: [],
  repulsors: [],
  aliens: [],
  minerals: [],
  runs: [],
});

/** Why a level is not simulated to its end, in words. */
export function limitInWords(limit: Limit): string {
  switch (limit) {
    case 'unchecked':
      return 'not simulated: checks are off for this level';
    case 'everything':
      return 'work limit: the level takes too much work to be simulated while it is edited';
    case 'run':
      return 'work limit: the run takes too much work to be simulated to its end while it is edited';
    case 'others':
      return 'work limit: not all runs of the level could be simulated while it is edited';
  }
}

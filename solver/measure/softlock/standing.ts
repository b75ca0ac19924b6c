import type { Hold } from '../../../schema/basics/index.ts';
import type { Proof } from '../../prove/index.ts';
import type { Moment } from '../../search/explore/index.ts';

/** What is known about a state: whether the black hole can still be reached from it. `is` tells the kinds apart. */
export type Standing =
  | {
      /** Not examined yet. */
      readonly is: 'unknown';
    }
  | {
      /** A run through this state completes the level; a replay from the start has confirmed it. */
      readonly is: 'open';
    }
  | {
      /** It is proved that no run completes the level from here. */
      readonly is: 'proved';
      /**
       * The proof, about the level that starts in this state, or in one before it on the way; the separate checker has confirmed
       * it.
       */
      readonly proof: Proof;
    }
  | {
      /** No run was found. This proves nothing. */
      readonly is: 'not found';
      /** How long the search from this state was, ticks. */
      readonly ticks: number;
    };

/** A state in which a run can be, and she is alive. */
export interface SurveyedState extends Moment {
  /** x of her centre, px. */
  readonly x: number;
  /** y of her centre, px. */
  readonly y: number;
  /** Whether the black hole can be reached from it. */
  readonly standing: Standing;
  /** The longest that she was seen alive after it, ticks; 0 where nothing was looked at. */
  readonly alive: number;
  /** Index of the level's own run that passes through it; null for a state that a search reached. */
  readonly run: number | null;
}

/** A place where a run goes from states from which the black hole can be reached to states from which it cannot. */
export interface LostPlace extends SurveyedState {
  /** The last tick on the way here at which the black hole could still be reached; null if none is known. */
  readonly open: number | null;
  /** How many of the states that were examined lie beyond: they are lost, and were reached near this place. */
  readonly states: number;
}

/** Since when a run was lost that does not complete the level, as far as it is known. All moments are moments of the run. */
export interface RunLoss {
  /** The holds of the run. */
  readonly holds: readonly Hold[];
  /** The last tick at which she is alive, or at which the longest run is over. */
  readonly last: number;
  /** Whether the run completes the level; then it is lost at no time. */
  readonly completes: boolean;
  /** The last tick at which the black hole is known to be in reach; null if none is known. */
  readonly open: number | null;
  /** The first moment that was examined from which no run was found, or that is proved lost; null if none is known. */
  readonly lost: SurveyedState | null;
  /** The first moment that is proved lost; null if none is. */
  readonly proved: SurveyedState | null;
}

import type { Candidate } from '../../verified-run.ts';
import type { Change } from './change.ts';

/** What makes a level completable: a change of the level, or only a run. A replay from the start has confirmed it. */
export interface Proposal {
  /** The change of the level; null when the level itself stays as it is. */
  readonly change: Change | null;
  /** The size of the change, px, as {@link changeSize} measures it; 0 without a change. */
  readonly size: number;
  /** The run that completes the changed level. */
  readonly run: Candidate;
  /** Where the run comes from. */
  readonly origin: RunOrigin;
}

/** Where the run of a proposal comes from. `from` tells the kinds apart. */
export type RunOrigin =
  | {
      /** It is one of the level's own runs, as it is. */
      readonly from: 'own';
      /** Index of the run in the level's list, from 0. */
      readonly index: number;
    }
  | {
      /** It is one of the level's own runs, with other holds. */
      readonly from: 'adjusted';
      /** Index of the run in the level's list, from 0. */
      readonly index: number;
      /** How far its presses and releases are shifted, ticks, all of them together. */
      readonly ticks: number;
    }
  | {
      /** A search found it. */
      readonly from: 'search';
    };

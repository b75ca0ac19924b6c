import type { Proof } from '../../../solver/index.ts';
import type { Results, Solving } from '../../workers/index.ts';
import type { Found } from './found-runs.ts';
import type { SearchSettings } from './search-settings.ts';

/** How the search of a level stands. */
export interface SearchState {
  /** `stale`: it was stopped since the level changed. */
  readonly phase: 'idle' | 'running' | 'done' | 'cancelled' | 'stale' | 'failed';
  /** Of a failure. */
  readonly message: string | null;
  /** ms spent */
  readonly ms: number;
  /** What it was asked for; null before the first search. */
  readonly settings: SearchSettings | null;
  readonly solving: Solving | null;
  /** Best first. */
  readonly found: readonly Found[];
  readonly impossible: Proof | null;
  readonly mineralProofs: Results['proofs']['minerals'];
  /** It is proved that the minerals asked for can't all be had. */
  readonly isHopeless: boolean;
  /** The level has changed since it was searched. */
  readonly isOld: boolean;
  /** Id of the one that is pointed at. */
  readonly hovered: string | null;
}

/** The level has changed since: nothing but the runs that were found says anything about it. @param found tried in the level as it is now */
export const afterChange = ({ phase }: SearchState, found: readonly Found[]): Partial<SearchState> => ({
  found,
  impossible: null,
  mineralProofs: [],
  isHopeless: false,
  isOld: true,
  solving: null,
  phase: phase === 'running' ? 'stale' : phase,
});

/** Before the first search. */
export const IDLE: SearchState = {
  phase: 'idle',
  message: null,
  ms: 0,
  settings: null,
  solving: null,
  found: [],
  impossible: null,
  mineralProofs: [],
  isHopeless: false,
  isOld: false,
  hovered: null,
};

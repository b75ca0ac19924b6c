import type { Proof } from '../../../solver/index.ts';
import type { Proofs, Solving } from '../../workers/index.ts';
import type { Found } from './found-runs.ts';
import type { SearchSettings } from './search-settings.ts';

/** The state of a level's search. */
export interface SearchState {
  /** `stale`: it was stopped because the level changed */
  readonly phase: 'idle' | 'running' | 'done' | 'cancelled' | 'stale' | 'failed';
  /** the message of a failure */
  readonly message: string | null;
  /** ms spent */
  readonly ms: number;
  /** The settings of the search; null before the first one. */
  readonly settings: SearchSettings | null;
  readonly solving: Solving | null;
  /** best first */
  readonly found: readonly Found[];
  readonly impossible: Proof | null;
  readonly mineralProofs: Proofs['minerals'];
  /** Whether it is proved that the wanted minerals can't all be collected. */
  readonly isHopeless: boolean;
  /** Whether the level has changed since the search. */
  readonly isOld: boolean;
  /** id of the run under the pointer */
  readonly hovered: string | null;
}

/**
 * The state after a change of the level: only the runs that were found still count. @param found those runs, checked in the
 * current level
 */
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

import type { Hold } from '../../schema/index.ts';
import type { Closest, Effort, Proof, Robustness, Solution } from '../../solver/index.ts';
import type { Round } from './lane-numbers.ts';
import type { SolveSettings } from './settings.ts';

/** The data that a worker thread starts with. */
export interface WorkerData {
  readonly settings: SolveSettings;
  /** The lanes of this worker. */
  readonly lanes: readonly number[];
  /** An Int32; any value but 0 is a request to stop soon. */
  readonly stop: SharedArrayBuffer;
}

/** A request to a worker; each gets one answer. */
export type Request =
  | { readonly kind: 'advance'; readonly round: Round }
  | { readonly kind: 'measure'; readonly holds: readonly Hold[] };

export interface LaneState {
  readonly lane: number;
  readonly effort: Effort;
  readonly closest: Closest | null;
  readonly solutions: readonly Solution[];
  /** A proof that there is no run; null if there is none. */
  readonly impossible: Proof | null;
  /** Whether nothing can improve any more. */
  readonly finished: boolean;
}

export type Answer =
  | { readonly kind: 'advance'; readonly lanes: readonly LaneState[] }
  | { readonly kind: 'measure'; readonly robustness: Robustness }
  | { readonly kind: 'failed'; readonly why: string };

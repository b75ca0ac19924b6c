import type { Hold } from '../../schema/index.ts';
import type { Closest, Effort, Robustness, Solution } from '../../solver/index.ts';
import type { SolveSettings } from './settings.ts';

/** What a worker thread starts with. */
export interface WorkerData {
  readonly settings: SolveSettings;
  /** The lanes that are its own. */
  readonly lanes: readonly number[];
  /** An Int32: anything but 0 asks to stop soon. */
  readonly stop: SharedArrayBuffer;
}

/** What a worker is asked for, each answered once. */
export type Request =
  | { readonly kind: 'advance'; readonly to: number }
  | { readonly kind: 'measure'; readonly holds: readonly Hold[] };

export interface LaneState {
  readonly lane: number;
  readonly effort: Effort;
  readonly closest: Closest | null;
  readonly solutions: readonly Solution[];
  /** Nothing can get better. */
  readonly finished: boolean;
}

export type Answer =
  | { readonly kind: 'advance'; readonly lanes: readonly LaneState[] }
  | { readonly kind: 'measure'; readonly robustness: Robustness }
  | { readonly kind: 'failed'; readonly why: string };

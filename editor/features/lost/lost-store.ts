import { createStore, type StoreApi } from 'zustand/vanilla';
import type { AccuracyName } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { ofDocument } from '../../core/kept/index.ts';
import type { Losing, Loss } from '../../workers/index.ts';

/** What is known of where the open level is already lost. */
export interface LostFindings {
  /**
   * `off`: not asked for. `waiting`: the level has just changed. `needs a run`: no run completes the level, so everything could be
   * lost. `done`: the effort is spent or nothing is left to examine.
   */
  readonly phase: 'off' | 'waiting' | 'needs a run' | 'examining' | 'done' | 'stopped' | 'failed';
  /** Why it failed; null: it did not. */
  readonly message: string | null;
  readonly losing: Losing | null;
  /** Since when runs were lost that fail, by {@link lossKey}. */
  readonly losses: ReadonlyMap<string, Loss>;
  /** The effort for the states, ticks. */
  readonly effort: number;
}

export type LostStore = StoreApi<LostFindings>;

/** Nothing is known, with this effort for what is to come. */
export const NOTHING_LOST = { message: null, losing: null, losses: new Map<string, Loss>() } as const;

/** What a run is known by: its effective holds, and the accuracy with which it was played. */
export const lossKey = (holds: readonly Hold[], accuracy: AccuracyName): string => `${accuracy} ${holds.join()}`;

/** What is known of where a level is already lost. */
export const lostOf = ofDocument(() => createStore<LostFindings>(() => ({ phase: 'off', effort: 0, ...NOTHING_LOST })));

import { createStore, type StoreApi } from 'zustand/vanilla';
import { ofDocument } from '../../core/kept/index.ts';
import type { Leeway } from '../../workers/index.ts';
import type { Question } from './question.ts';

/** What is known of where the selection may stand. */
export interface LeewayFindings {
  /**
   * `off`: it is not shown. `nothing selected`: it is, but nothing is asked. `waiting`: the level has just changed. `too large`:
   * the level takes too much work. `done`: nothing finer is sampled.
   */
  readonly phase: 'off' | 'nothing selected' | 'waiting' | 'sampling' | 'done' | 'too large' | 'failed';
  /** Why it failed, or why the level is not simulated; null: neither. */
  readonly message: string | null;
  /** What was asked, and what is known; null: nothing is. */
  readonly answer: { readonly question: Question; readonly leeway: Leeway } | null;
  /** The place of an object with several that is moved alone; null: all of them. */
  readonly only: number | null;
}

export type LeewayStore = StoreApi<LeewayFindings>;

/** What is known of where the selection of a level may stand. */
export const leewayOf = ofDocument(() =>
  createStore<LeewayFindings>(() => ({ phase: 'off', message: null, answer: null, only: null })),
);

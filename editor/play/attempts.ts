import { createStore, type StoreApi } from 'zustand/vanilla';
import type { AccuracyName } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { RunEnd } from '../proof/index.ts';

/** One attempt of a person at a level. */
export interface Attempt {
  /** Counted from 1 within the level. */
  readonly number: number;
  readonly holds: readonly Hold[];
  readonly end: RunEnd;
  readonly minerals: number;
  readonly accuracy: AccuracyName;
  /** x, y at every tick, px. */
  readonly points: Float32Array;
}

/** The last so many are kept: each is a line on the canvas. */
const KEPT = 24;

export interface Attempts {
  readonly store: StoreApi<readonly Attempt[]>;
  add(attempt: Omit<Attempt, 'number'>): Attempt;
  clear(): void;
}

/** The attempts at one level, the last one at the end. */
export function createAttempts(): Attempts {
  const store = createStore<readonly Attempt[]>(() => []);
  let count = 0;
  return {
    store,
    add(attempt) {
      const numbered = { ...attempt, number: ++count };
      store.setState([...store.getState(), numbered].slice(-KEPT), true);
      return numbered;
    },
    clear: () => store.setState([], true),
  };
}

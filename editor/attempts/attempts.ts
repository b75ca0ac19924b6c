import { createStore, type StoreApi } from 'zustand/vanilla';
import { outcomeAsPredicate, type RunEnd } from '../../check/words/index.ts';
import { type AccuracyName, TICK } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';

/** One attempt of the user at a level. */
export interface Attempt {
  /** Counted from 1 within the level. */
  readonly number: number;
  readonly holds: readonly Hold[];
  /** null: left before it ended */
  readonly end: RunEnd | null;
  /** the last tick that was played */
  readonly tick: number;
  readonly minerals: number;
  readonly accuracy: AccuracyName;
  /** x, y at every tick, px */
  readonly points: Float32Array;
}

/** number of attempts that are kept, as each is a line on the canvas */
const KEPT = 24;

export interface Attempts {
  readonly store: StoreApi<readonly Attempt[]>;
  add(attempt: Omit<Attempt, 'number'>): Attempt;
  clear(): void;
}

/** The attempts at one level, the latest last. */
export function createAttempts(): Attempts {
  const store = createStore<readonly Attempt[]>(() => []);
  let count = 0;
  return {
    store,
    add(attempt) {
      const numbered = { ...attempt, number: ++count };
      const all = [...store.getState(), numbered];
      // unfinished attempts are dropped first
      const spare = all.slice(0, -1).find(({ end }) => end === null) ?? all[0];
      store.setState(all.length > KEPT ? all.filter((one) => one !== spare) : all, true);
      return numbered;
    },
    clear: () => store.setState([], true),
  };
}

/** How an attempt ended, in words: `collides with nova 3 at 3.22 s`, `was left at 3.20 s`. @param range of the level, px */
export const attemptInWords = ({ end, tick }: Pick<Attempt, 'end' | 'tick'>, range: number): string =>
  end === null ? `was left at ${(tick * TICK).toFixed(2)} s` : outcomeAsPredicate(end, range);

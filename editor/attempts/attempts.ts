import { createStore, type StoreApi } from 'zustand/vanilla';
import { outcomeAsPredicate, type RunEnd } from '../../check/words/index.ts';
import { type AccuracyName, TICK } from '../../engine/index.ts';
import type { Hold, LevelFile, OwnRules } from '../../schema/index.ts';
import { keptWith } from '../kept/index.ts';

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
  /** What it takes to send it. */
  readonly played: PlayedOn;
}

/** A play as a file, and the level that it was played on. */
export interface PlayedOn {
  /** The content of its `.gqr` file. */
  readonly bytes: Uint8Array;
  /** The hash of the level, which does not depend on its name or runs. */
  readonly hash: string;
  readonly file: LevelFile;
  /** The rules of the folder. */
  readonly rules: OwnRules;
}

/** number of attempts that are kept, as each is a line on the canvas */
const KEPT = 24;

export interface Attempts {
  readonly store: StoreApi<readonly Attempt[]>;
  add(attempt: Omit<Attempt, 'number'>): Attempt;
  remove(number: number): void;
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
    remove: (number) =>
      store.setState(
        store.getState().filter((one) => one.number !== number),
        true,
      ),
    clear: () => store.setState([], true),
  };
}

/** The attempts at a level, by its document; they stay while the page lives, also when another level is opened in the meantime. */
export const attemptsAt = keptWith<object, Attempts>(createAttempts);

/** How an attempt ended, in words: `collides with nova 3 at 3.22 s`, `was left at 3.20 s`. @param range of the level, px */
export const attemptInWords = ({ end, tick }: Pick<Attempt, 'end' | 'tick'>, range: number): string =>
  end === null ? `was left at ${(tick * TICK).toFixed(2)} s` : outcomeAsPredicate(end, range);

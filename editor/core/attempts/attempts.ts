import { createStore, type StoreApi } from 'zustand/vanilla';
import type { FailureCause } from '../../../check/plays/index.ts';
import { bodyInWords, outcomeAsPredicate, type RunEnd } from '../../../check/words/index.ts';
import { type AccuracyName, TICK } from '../../../engine/index.ts';
import type { Hold, LevelFile, OwnRules } from '../../../schema/index.ts';
import { keptWith } from '../kept/index.ts';

/** One attempt of the user at a level. */
export interface Attempt {
  /** Unlike its number, the same in every page. */
  readonly id: string;
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
interface PlayedOn {
  /** The content of its `.gqr` file. */
  readonly bytes: Uint8Array;
  /** The hash of the level, which does not depend on its name or runs. */
  readonly hash: string;
  readonly file: LevelFile;
  /** The rules of the folder. */
  readonly rules: OwnRules;
}

/** number of attempts that are kept of a level: each has about 30 kB for 60 s */
const KEPT = 200;

/** What is added as an attempt. */
type NewAttempt = Omit<Attempt, 'id' | 'number'>;

export interface Attempts {
  readonly store: StoreApi<readonly Attempt[]>;
  add(attempt: NewAttempt): Attempt;
  /** Adds attempts of earlier pages before those of this page, except those that are there. */
  restore(earlier: readonly Attempt[]): void;
  remove(number: number): void;
  clear(): void;
}

const newId = (): string => crypto.getRandomValues(new Uint32Array(4)).join('-');

/** Numbers that grow: attempts of several pages may have the same. */
function numbered(attempts: readonly Attempt[]): Attempt[] {
  let last = 0;
  return attempts.map((attempt) => {
    last = Math.max(last + 1, attempt.number);
    return attempt.number === last ? attempt : { ...attempt, number: last };
  });
}

/** The attempts at one level, the latest last. */
export function createAttempts(): Attempts {
  const store = createStore<readonly Attempt[]>(() => []);
  let count = 0;
  return {
    store,
    add(attempt) {
      const added = { ...attempt, id: newId(), number: ++count };
      const all = [...store.getState(), added];
      // unfinished attempts are dropped first
      const spare = all.slice(0, -1).find(({ end }) => end === null) ?? all[0];
      store.setState(all.length > KEPT ? all.filter((one) => one !== spare) : all, true);
      return added;
    },
    restore(earlier) {
      const here = store.getState();
      const known = new Set(here.map(({ id }) => id));
      const missing = earlier.filter(({ id }) => !known.has(id));
      if (missing.length === 0) return;
      const inOrder = [...missing].sort((a, b) => a.number - b.number || (a.id < b.id ? -1 : 1));
      const all = numbered([...inOrder, ...here]);
      count = Math.max(count, ...all.map(({ number }) => number));
      store.setState(all, true);
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

/** Why she fails, to follow "she": `hits nova 3`, `is lost`. */
export const causeInWords = ({ kind, index }: FailureCause): string => {
  if (index !== null) return `hits ${bodyInWords({ kind, index })}`;
  if (kind === 'lost') return 'is lost';
  if (kind === 'timeout') return 'runs out of time';
  return kind === 'left' ? 'is left before the end' : 'collects too few minerals';
};

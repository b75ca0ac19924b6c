import type { Player } from '../../../engine/work-precision/index.ts';

export interface TurnsOptions {
  /** A clock, ms. */
  readonly now: () => number;
  /** Lets the page draw and respond between samples. */
  readonly pause: () => Promise<void>;
  readonly signal: AbortSignal;
}

/** least duration of a sample in ms: many times the resolution of a browser's clock */
const SAMPLE = 2;
const ROUNDS = 24;
/** warm-up rounds, which are not counted */
const WARM_UP = 3;

/**
 * Times players in turns, so that a slowdown of the machine affects all of them; the page draws between samples.
 * @returns the samples of each player, one per round, in microseconds per simulated second; null if aborted
 */
export async function timeInTurns(
  players: readonly Player[],
  { now, pause, signal }: TurnsOptions,
): Promise<readonly (readonly number[])[] | null> {
  const samples = players.map((): number[] => []);
  for (let round = 0; round < WARM_UP + ROUNDS; round++) {
    for (let k = 0; k < players.length; k++) {
      if (signal.aborted) return null;
      const i = (round + k) % players.length;
      const start = now();
      let seconds = 0;
      let spent = 0;
      while (spent < SAMPLE) {
        seconds += players[i].play();
        spent = now() - start;
      }
      if (round >= WARM_UP) samples[i].push((1000 * spent) / seconds);
      await pause();
    }
  }
  return samples;
}

/** Lets the page draw and respond. */
export const nextTurn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

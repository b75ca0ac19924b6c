import type { Player } from '../../../engine/work-precision/index.ts';

export interface TurnsOptions {
  /** A clock, ms. */
  readonly now: () => number;
  /** Lets the page draw and answer before it goes on. */
  readonly pause: () => Promise<void>;
  readonly signal: AbortSignal;
}

/** One sample takes at least so long, ms: many times what a browser's clock is rounded to. */
const SAMPLE = 2;
const ROUNDS = 24;
/** Rounds that warm up and are not counted. */
const WARM_UP = 3;

/**
 * Times players in turns, so that what slows the machine for a while slows all; the page draws between any two samples.
 * @returns for each player its samples, one a round, microseconds per simulated second; null when it was aborted
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

/** Lets the page draw and answer. */
export const nextTurn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

import type { Player } from '../../../engine/work-precision/index.ts';

/** least duration of a sample in ms: many times the resolution of a browser's clock */
const SAMPLE = 2;
const ROUNDS = 24;
/** warm-up rounds, which are not counted */
const WARM_UP = 3;

/**
 * Times players in turns, so that a slowdown of the machine affects all of them. Yields after every sample.
 * @param now a clock, ms
 * @returns the samples of each player, one per round, in microseconds per simulated second
 */
export function* timeInTurns(
  players: readonly Player[],
  now: () => number,
): Generator<null, readonly (readonly number[])[], void> {
  const samples = players.map((): number[] => []);
  for (let round = 0; round < WARM_UP + ROUNDS; round++) {
    for (let k = 0; k < players.length; k++) {
      const i = (round + k) % players.length;
      const start = now();
      let seconds = 0;
      let spent = 0;
      while (spent < SAMPLE) {
        seconds += players[i].play();
        spent = now() - start;
      }
      if (round >= WARM_UP) samples[i].push((1000 * spent) / seconds);
      yield null;
    }
  }
  return samples;
}

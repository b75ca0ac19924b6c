import type { Hold, Level } from '../../schema/basics/index.ts';
import type { Accuracy } from '../accuracy.ts';
import { compile } from '../compile.ts';
import { TICK } from '../constants.ts';
import { joinHolds, playScript } from '../script.ts';
import { createSimulation } from '../simulate.ts';

/** Something whose cost per simulated second is measured. */
export interface Player {
  /** Called before each `play`; not timed. */
  prepare?(): void;
  /** Does the work once; returns the seconds it simulated. */
  play(): number;
}

/** A cost in microseconds per simulated second. */
export interface Cost {
  readonly minimum: number;
  readonly median: number;
}

interface CostOptions {
  /** Approximate time for the whole measurement, ms. */
  readonly budget: number;
  /** Shortest time of one sample, ms; shorter work is repeated within the sample. */
  readonly sample: number;
}

const FEWEST_ROUNDS = 5;
const MOST_ROUNDS = 41;
/** Largest number of plays that are timed together to find out how long one takes. */
const MOST_PLAYS = 1024;

/**
 * Times players against each other. They take turns (A B C, B C A, ...), so a disturbance of the machine affects all of them.
 * @param now - a clock, ms
 * @returns one cost per player, in the same order
 */
export function measureCosts(players: readonly Player[], now: () => number, { budget, sample }: CostOptions): Cost[] {
  const time = (player: Player, times: number): readonly [ms: number, seconds: number] => {
    let ms = 0;
    let seconds = 0;
    if (player.prepare === undefined) {
      const start = now();
      for (let i = 0; i < times; i++) seconds += player.play();
      return [now() - start, seconds];
    }
    for (let i = 0; i < times; i++) {
      player.prepare();
      const start = now();
      seconds += player.play();
      ms += now() - start;
    }
    return [ms, seconds];
  };

  // a quarter of the budget is for warming up, so that shared code is optimised for all before anything counts
  const warmUp = budget / 4 / players.length;
  const once = players.map((player) => {
    const until = now() + warmUp;
    // a coarse clock, as in pages that are not isolated, cannot time one play: as many as it can time
    let plays = 1;
    let ms = time(player, plays)[0];
    while (ms < Math.min(sample, warmUp) && plays < MOST_PLAYS) {
      plays *= 2;
      ms = time(player, plays)[0];
    }
    let least = ms / plays;
    while (now() < until) least = Math.min(least, time(player, plays)[0] / plays);
    return least;
  });
  const times = once.map((ms) => Math.max(1, Math.round(sample / Math.max(ms, 1e-3))));
  const round = once.reduce((sum, ms, i) => sum + ms * times[i], 0);
  const rounds = Math.max(FEWEST_ROUNDS, Math.min(MOST_ROUNDS, Math.floor((0.75 * budget) / Math.max(round, 1e-3))));

  const samples = players.map((): number[] => []);
  for (let r = 0; r < rounds; r++) {
    for (let k = 0; k < players.length; k++) {
      const i = (r + k) % players.length;
      const [ms, seconds] = time(players[i], times[i]);
      samples[i].push((1000 * ms) / seconds);
    }
  }
  return samples.map((list) => {
    list.sort((a, b) => a - b);
    return { minimum: list[0], median: list[list.length >> 1] };
  });
}

/** A player that plays holds on levels at one setting, one after the other. */
export function playerOf(
  runs: readonly { readonly level: Level; readonly holds: readonly Hold[] }[],
  accuracy: Accuracy,
  maxTicks: number,
): Player {
  const made = runs.map(({ level, holds }) => ({
    simulation: createSimulation(compile(level, accuracy)),
    script: joinHolds(holds),
  }));
  return {
    play() {
      let seconds = 0;
      for (const { simulation, script } of made) {
        simulation.reset();
        playScript(simulation, script, maxTicks);
        seconds += simulation.ending?.time ?? simulation.tick * TICK;
      }
      return seconds;
    },
  };
}

/**
 * A quantile by linear interpolation between the closest ranks; `p` is from 0 to 1.
 * @throws {RangeError} if there are no values
 */
export function quantile(values: readonly number[], p: number): number {
  if (values.length === 0) throw new RangeError('expected at least one value, found none');
  const sorted = [...values].sort((a, b) => a - b);
  const place = p * (sorted.length - 1);
  const low = Math.floor(place);
  const high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (place - low) * (sorted[high] - sorted[low]);
}

import { createSimulation, type Scene, type Simulation } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { type Goal, mineralsNeeded } from '../../goal.ts';
import { createRandom, type Random } from '../../random.ts';
import { wilsonInterval } from '../robustness/index.ts';
import { wins } from './wins.ts';

/** How often a player wins who presses at random. */
export interface RandomPlay {
  /** The share of games that meet the goal, 0 to 1. */
  readonly share: number;
  /** Lower end of the 95 % confidence interval (Wilson's score interval), 0 to 1. */
  readonly low: number;
  /** Upper end of the 95 % confidence interval, 0 to 1. */
  readonly high: number;
  /** How many games were played. */
  readonly samples: number;
}

/** A random player waits and holds for 1 to this many ticks (two seconds), all lengths equally likely. */
export const RANDOM_PLAY_LONGEST = 120;

/**
 * Plays one random game from the start. It begins with a pause or a hold, equally likely. Pauses and holds alternate, each from
 * 1 to {@link RANDOM_PLAY_LONGEST} ticks long, until the run ends or `maxTicks` have passed.
 * @returns the holds that were played
 */
export function playGameAtRandom(simulation: Simulation, random: Random, maxTicks: number): Hold[] {
  simulation.reset();
  const holds: Hold[] = [];
  let held = random.below(2) === 1;
  while (simulation.ending === null && simulation.tick < maxTicks) {
    const from = simulation.tick;
    const length = Math.min(1 + random.below(RANDOM_PLAY_LONGEST), maxTicks - from);
    simulation.advance(length, held);
    if (held) holds.push([from, from + length]);
    held = !held;
  }
  return holds;
}

/** Measures the share of random games that meet a goal. */
export function playAtRandom(scene: Scene, goal: Goal, options: { samples: number; seed: number; maxTicks: number }): RandomPlay {
  const { samples, seed, maxTicks } = options;
  const needed = mineralsNeeded(goal, scene.minerals.count);
  const random = createRandom(seed);
  const simulation = createSimulation(scene);
  let won = 0;
  for (let sample = 0; sample < samples; sample++) {
    playGameAtRandom(simulation, random, maxTicks);
    if (wins(simulation, needed)) won++;
  }
  return { share: samples === 0 ? 0 : won / samples, ...wilsonInterval(won, samples), samples };
}

import { createSimulation, type Scene, type Simulation } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { type Goal, mineralsNeeded } from '../goal.ts';
import { createRandom, type Random } from '../random.ts';
import { wilsonInterval } from '../robustness/index.ts';
import { wins } from './wins.ts';

/** How often somebody wins who presses at random. */
export interface RandomPlay {
  /** 0 to 1 */
  readonly share: number;
  /** 95 % interval (Wilson) */
  readonly low: number;
  readonly high: number;
  readonly samples: number;
}

/** A random player waits and holds for a whole number of ticks, each length from 1 to this equally likely (two seconds). */
export const RANDOM_PLAY_LONGEST = 120;

/**
 * Plays one game at random, from the start. Such a player begins with a pause or with a hold, equally likely; then pauses and holds take
 * turns, the length of each drawn evenly from 1 to {@link RANDOM_PLAY_LONGEST} ticks, until the run ends or `maxTicks` have passed.
 * @returns what was held
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

/** The share of random games that meet a goal. */
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

import { compile, createSimulation, TICK_RATE, type WorkBudget } from '../../engine/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import { createRandom } from '../random.ts';
import { distance } from './rounding.ts';

/** Whether she moves at the start, or a field or a wind moves her at once. At rest she can wait for any time. */
export const startsMoving = ({ astronaut, repulsors, winds }: Level): boolean =>
  astronaut.vx !== 0 ||
  astronaut.vy !== 0 ||
  [...repulsors, ...winds].some((field) => distance(field, astronaut) <= field.radius);

/** Random plays that are sampled. */
const PLAYS = 120;

/**
 * Returns a function that tells the length of the longest of some random plays, s, from which provers guess how far they have to
 * follow her; null when one lasts longer than `most` seconds or completes the level, so that following all plays is hopeless.
 * Several provers ask, so the plays are played again only for more seconds than before.
 */
export function longestPlays(level: Level, budget: WorkBudget): (most: number) => number | null {
  let asked = 0;
  let known: number | null = null;
  return (most) => {
    if (known === null && most > asked) {
      known = longestPlay(level, most, budget);
      asked = most;
    }
    return known !== null && known <= most ? known : null;
  };
}

function longestPlay(level: Level, most: number, budget: WorkBudget): number | null {
  const simulation = createSimulation(compile(level), budget);
  const random = createRandom(0);
  const last = Math.floor(most * TICK_RATE);
  let longest = 0;
  for (let play = 0; play < PLAYS; play++) {
    simulation.reset();
    let held = play % 2 === 1;
    // The first two plays are an endless hold and an endless drift.
    const piece = play < 2 ? last : 8 << (play % 4);
    while (simulation.ending === null && simulation.tick < last) {
      simulation.advance(play < 2 ? piece : 1 + random.below(piece), held);
      held = !held;
    }
    if (simulation.ending === null || simulation.ending.outcome === 'completed') return null;
    longest = Math.max(longest, simulation.ending.time);
  }
  return longest;
}

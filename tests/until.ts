import { setTimeout } from 'node:timers/promises';

/** ms between two looks */
const PAUSE = 10;

/** Waits until a condition holds, for what no event tells of. The time limit of the test ends a wait for what never comes. */
export async function until(condition: () => boolean): Promise<void> {
  while (!condition()) await setTimeout(PAUSE);
}

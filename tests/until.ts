import { setTimeout } from 'node:timers/promises';

/** ms between two tries */
const PAUSE = 10;

/** Waits until a condition holds that no event announces. If it never holds, the time limit of the test ends the wait. */
export async function until(condition: () => boolean): Promise<void> {
  while (!condition()) await setTimeout(PAUSE);
}

import { createSimulation, type Scene, type Simulation, TICK_RATE } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { seeded } from './seeded.ts';

const MINUTE = 60 * TICK_RATE;
/** Ticks between a press and a release, or a release and a press. With their mean, a minute has 24 of them. */
const SHORTEST = 60;
const LONGEST = 240;
/** After so many failures in a row the walk goes back further. */
const PATIENCE = 8;
const MOST_TRIES = 20_000;

/**
 * Holds of a play of a minute on a level as it is: a random walk from press to release to press, which goes back whenever the
 * play would end. null if none was found.
 */
export function minuteOfPlay(scene: Scene, seed: number): Hold[] | null {
  const random = seeded(seed);
  const simulation: Simulation = createSimulation(scene);
  const path: { edge: number; before: Float64Array }[] = [];
  let failures = 0;
  for (let tries = 0; tries < MOST_TRIES; tries++) {
    const before = simulation.snapshot();
    const from = simulation.tick;
    const length = Math.min(MINUTE - from, SHORTEST + Math.floor((LONGEST - SHORTEST) * random()));
    simulation.advance(length, path.length % 2 === 1);
    if (simulation.ending === null) {
      path.push({ edge: from + length, before });
      failures = 0;
      if (simulation.tick >= MINUTE) return holdsOf(path.map(({ edge }) => edge));
      continue;
    }
    simulation.restore(before);
    failures++;
    if (failures % PATIENCE === 0) {
      const back = Math.min(path.length, 1 + Math.floor((failures / PATIENCE) * random() * 2));
      const [point] = path.splice(path.length - back);
      if (point !== undefined) simulation.restore(point.before);
    }
  }
  return null;
}

/** The spans between edges are not held, held, not held, and so on. */
function holdsOf(edges: readonly number[]): Hold[] {
  const holds: Hold[] = [];
  for (let i = 0; i + 1 < edges.length; i += 2) holds.push([edges[i], edges[i + 1]]);
  return holds;
}

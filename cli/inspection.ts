import type { Mode, Scene, Work } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import type { ShownProblem } from './shown-problem.ts';

/** What `gq inspect` finds out about a level. */
export interface Inspection {
  readonly file: string;
  /** The level's name. */
  readonly level: string;
  readonly effects: Scene['effects'];
  readonly counts: Readonly<Record<string, number>>;
  /** How the time of the first run is spent; empty without a run. */
  readonly modes: readonly Mode[];
  /** What the first run cost. */
  readonly work: Work;
  readonly problems: readonly ShownProblem[];
}

/** How many of everything a level has. */
export function countObjects(level: Level): Record<string, number> {
  const hot = level.asteroids.filter((asteroid) => asteroid.hot).length;
  return {
    coldAsteroids: level.asteroids.length - hot,
    hotAsteroids: hot,
    novae: level.novae.length,
    repulsors: level.repulsors.length,
    aliens: level.aliens.length,
    minerals: level.minerals.length,
    runs: level.runs.length,
  };
}

import type { Scene } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import type { ShownProblem } from './shown-problem.ts';

/** What simulating a run took. */
export interface Work {
  /** Pieces of motion between events; frames, under `arcade`. */
  readonly pieces: number;
  readonly forceEvaluations: number;
  /** Event conditions followed along pieces. */
  readonly guards: number;
  /** Event times sought on a piece. */
  readonly roots: number;
}

/** What `gq inspect` finds out about a level. */
export interface Inspection {
  readonly file: string;
  /** The level's name. */
  readonly level: string;
  readonly effects: Scene['effects'];
  readonly counts: Readonly<Record<string, number>>;
  /** How much of the run is spent in which mode. */
  readonly modes: readonly { readonly name: string; readonly share: number }[];
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

import { createSimulation, joinHolds, playScript, type Scene, TICK_RATE } from '../engine/index.ts';
import type { Hold, Level } from '../schema/index.ts';
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

/**
 * Plays a script for the work that it takes, nothing recorded.
 * @param maxTime s
 */
export function measureWork(scene: Scene, holds: readonly Hold[], maxTime: number): Work {
  const simulation = createSimulation(scene);
  playScript(simulation, joinHolds(holds), Math.round(maxTime * TICK_RATE));
  if ('work' in simulation) return simulation.work as Work;
  // a frame of `arcade` is a piece with one evaluation; it tests contacts at frames: no guard is followed, no root sought
  return { pieces: simulation.tick, forceEvaluations: simulation.tick, guards: 0, roots: 0 };
}

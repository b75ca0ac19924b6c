import type { Scene } from './scene.ts';

/** How a run ended. */
export type Outcome = 'completed' | 'collided' | 'lost' | 'timeout';

/** What can end a run by touch. */
export type BodyKind = 'blackHole' | 'nova' | 'asteroid' | 'alien';

/** What she touched last: `index` counts within the level's own list of that kind. */
export interface Touched {
  readonly kind: BodyKind;
  readonly index: number;
}

/** How a simulation ended; `time` in s from the start, `tick` the 1/60 s tick it falls in. */
export interface Ending {
  readonly outcome: Exclude<Outcome, 'timeout'>;
  readonly with: Touched | null;
  readonly time: number;
  readonly tick: number;
}

/** Something that happened in a run. `time` in s; indices count within the level's list of that kind. */
export type RunEvent =
  | { readonly time: number; readonly type: 'press' | 'release' }
  | { readonly time: number; readonly type: 'target'; readonly index: number }
  | { readonly time: number; readonly type: 'mineral'; readonly index: number }
  | { readonly time: number; readonly type: 'enter' | 'leave'; readonly index: number }
  | { readonly time: number; readonly type: 'wake' | 'sleep'; readonly index: number }
  | { readonly time: number; readonly type: 'explosion'; readonly aliens: readonly [number, number] }
  /** Something of an effect's own: `what` happened with its thing `index`; {@link effectEventInWords}. */
  | { readonly time: number; readonly type: 'effect'; readonly effect: string; readonly what: string; readonly index: number }
  | { readonly time: number; readonly type: Exclude<Outcome, 'timeout'>; readonly with: Touched | null };

/** What a run cost. Under `arcade` a piece is a frame, and a guard a test for contact. */
export interface Work {
  readonly pieces: number;
  readonly forceEvaluations: number;
  readonly guards: number;
  readonly roots: number;
}

/** A mode of motion and its share of the simulated time, 0 to 1. */
export interface Mode {
  readonly name: string;
  readonly share: number;
}

/** Doubles per state in a trajectory: x, y (px), vx, vy (px/s), cos, sin of the box's x axis. */
export const STATE_SIZE = 6;

/**
 * A run in progress, advanced by ticks with the state of the button: what a playtest, a search and `simulate` step.
 * Advancing in one call or in many gives the same bits. Allocates nothing while it runs unless something is recorded.
 */
export interface Simulation {
  readonly scene: Scene;
  /** Ticks advanced since the start. */
  readonly tick: number;
  /** How it ended, or null while it goes on. */
  readonly ending: Ending | null;
  /** Work done since the start or the last reset. */
  readonly work: Work;
  /** How the time since then was spent. */
  readonly modes: readonly Mode[];
  /** Minerals counted so far. */
  readonly mineralCount: number;
  /**
   * Advances by at most `ticks` ticks of 1/60 s with the gun held or not; stops at the tick in which the run ends.
   * @returns the ticks advanced; fewer than asked when the run ended
   */
  advance(ticks: number, held: boolean): number;
  /** Writes x, y, vx, vy, cos, sin of the astronaut into `out`. */
  readState(out: Float64Array): void;
  /** Writes x, y, alive (1, or 0 when exploded) of every alien into `out` (3 doubles each). */
  readAliens(out: Float64Array): void;
  /** False while every alien is as it was at the start; true where one may be elsewhere, or have exploded. */
  readonly mayAliensHaveStirred: boolean;
  /** Writes x, y of every asteroid, in the level's order, into `out` (2 doubles each): recoil moves them. */
  readAsteroids(out: Float64Array): void;
  /** Whether the mineral with this index in the level's list has been collected. */
  isCollected(mineral: number): boolean;
  /** Copies everything that changes into a typed array (`into` when given and of the right length). */
  snapshot(into?: Float64Array): Float64Array;
  /** Goes back to a snapshot of the same scene. */
  restore(snapshot: Float64Array): void;
  /** Goes back to the start. */
  reset(): void;
}

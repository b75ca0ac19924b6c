import type { Scene } from './scene.ts';

/**
 * How a run ends: `completed` (she touches the black hole), `collided` (she touches a nova, a hot asteroid or an alien), `lost`
 * (she is farther than the range from every asteroid) or `timeout` (none of these within the simulated time).
 */
export type Outcome = 'completed' | 'collided' | 'lost' | 'timeout';

/** The kinds of objects whose touch ends a run. `asteroid` means a hot asteroid. */
export type BodyKind = 'blackHole' | 'nova' | 'asteroid' | 'alien';

/** The object whose touch ended a run. */
export interface Touched {
  /** The kind of the object. */
  readonly kind: BodyKind;
  /** Index within the level's own list of that kind, from 0; 0 for the black hole. */
  readonly index: number;
}

/** How and when a simulation ended. */
export interface Ending {
  /** How it ended. A simulation has no time limit of its own, so this is never `timeout`. */
  readonly outcome: Exclude<Outcome, 'timeout'>;
  /** The object she touched; null when she was lost. */
  readonly with: Touched | null;
  /** When it ended, s from the start. */
  readonly time: number;
  /** The tick of 1/60 s that `time` falls in; under `arcade` the frame whose update raised the outcome. */
  readonly tick: number;
}

/** A moment of a run at which the motion changes, something is collected, or the run ends. `type` tells the kinds apart. */
export type RunEvent =
  | {
      /** When it happened, s from the start. */
      readonly time: number;
      /** The gun begins (`press`) or ceases (`release`) to be held. */
      readonly type: 'press' | 'release';
    }
  | {
      /** When it happened, s from the start. */
      readonly time: number;
      /** The held gun has a new target. */
      readonly type: 'target';
      /** Index of the new target within the level's asteroids, from 0. */
      readonly index: number;
    }
  | {
      /** When it happened, s from the start. */
      readonly time: number;
      /** She collects a mineral. */
      readonly type: 'mineral';
      /** Index within the level's minerals, from 0. */
      readonly index: number;
    }
  | {
      /** When it happened, s from the start. */
      readonly time: number;
      /** Her centre enters or leaves the field of a repulsor. */
      readonly type: 'enter' | 'leave';
      /** Index within the level's repulsors, from 0. */
      readonly index: number;
    }
  | {
      /** When it happened, s from the start. */
      readonly time: number;
      /** An alien begins (`wake`) or ceases (`sleep`) to chase her. */
      readonly type: 'wake' | 'sleep';
      /** Index within the level's aliens, from 0. */
      readonly index: number;
    }
  | {
      /** When it happened, s from the start. */
      readonly time: number;
      /** Two aliens touch each other and explode. */
      readonly type: 'explosion';
      /** Indices of both within the level's aliens, from 0. */
      readonly aliens: readonly [number, number];
    }
  | {
      /** When it happened, s from the start. */
      readonly time: number;
      /** An event of a kind that an effect defines for itself; {@link effectEventInWords} puts it into words. */
      readonly type: 'effect';
      /** Name of the effect, as in {@link Effect}. */
      readonly effect: string;
      /** What happened: a key of the effect's `tells`. */
      readonly what: string;
      /** Index of the object within the level's list of the effect's objects, from 0. */
      readonly index: number;
    }
  | {
      /** When it happened, s from the start. */
      readonly time: number;
      /** The run ends with this outcome. */
      readonly type: Exclude<Outcome, 'timeout'>;
      /** The object she touched; null when she was lost. */
      readonly with: Touched | null;
    };

/** What a run cost, as counts that are the same on every machine. */
export interface Work {
  /** Pieces of motion; under `arcade` frames. */
  readonly pieces: number;
  /** Evaluations of the force; under `arcade` frames with the gun held. */
  readonly forceEvaluations: number;
  /** Guards that were followed; under `arcade` tests for contact. */
  readonly guards: number;
  /** Roots of guards that were located; always 0 under `arcade`. */
  readonly roots: number;
}

/** A mode of motion and how much of the simulated time was spent in it. */
export interface Mode {
  /**
   * `coast`, `pull`, `pull on a line`, `push`, `push on a line`, `slide on a rim` or `steady force`; under `arcade` only
   * `coast` and `pull`.
   */
  readonly name: string;
  /** Share of the simulated time, above 0 and up to 1. */
  readonly share: number;
}

/**
 * Doubles in one state of the astronaut: x, y (px, from the level's origin), vx, vy (px/s), and cos, sin of the angle of the
 * collision box's x axis.
 */
export const STATE_SIZE = 6;

/**
 * A run in progress. The caller advances it by ticks and says whether the gun is held. Playtests, searches and {@link simulate}
 * use it.
 *
 * Advancing in one call or in many gives the same bits. Nothing is allocated while it runs, unless the run is recorded.
 */
export interface Simulation {
  /** The scene that is simulated. */
  readonly scene: Scene;
  /** Ticks of 1/60 s since the start. */
  readonly tick: number;
  /** How the run ended; null while it goes on. */
  readonly ending: Ending | null;
  /** Work done since the start or the last {@link Simulation.reset}. */
  readonly work: Work;
  /** How the simulated time since then is divided among the modes of motion. Modes that did not occur are left out. */
  readonly modes: readonly Mode[];
  /** Minerals collected so far. `arcade` may count one twice, as the original game did. */
  readonly mineralCount: number;
  /** Time since the start, s: the end of the last tick, or when the run ended. */
  readonly time: number;
  /**
   * The asteroid that the gun pulls her towards: its index within the level's asteroids, from 0. null while the gun is not held,
   * where it reaches no asteroid, and after the end.
   */
  readonly target: number | null;
  /**
   * Advances by at most `ticks` ticks of 1/60 s. Stops in the tick in which the run ends.
   *
   * @param ticks - how many ticks to advance, a whole number from 0
   * @param held - whether the gun is held during these ticks
   * @returns the ticks advanced; fewer than asked for when the run ended
   * @throws {@link WorkLimitReached} when the simulation's budget is used up
   */
  advance(ticks: number, held: boolean): number;
  /**
   * Writes the state of the astronaut: x, y (px), vx, vy (px/s), cos, sin.
   *
   * @param out - receives {@link STATE_SIZE} doubles
   */
  readState(out: Float64Array): void;
  /**
   * Writes x, y (px) and alive (1, or 0 once exploded) of every alien, in the level's order.
   *
   * @param out - receives 3 doubles per alien
   */
  readAliens(out: Float64Array): void;
  /** False while every alien is as it was at the start. True when one may have moved or exploded. */
  readonly mayAliensHaveStirred: boolean;
  /**
   * Writes x, y (px) of every asteroid, in the level's order. Recoil moves asteroids.
   *
   * @param out - receives 2 doubles per asteroid
   */
  readAsteroids(out: Float64Array): void;
  /**
   * Says whether a mineral has been collected.
   *
   * @param mineral - index within the level's minerals, from 0
   * @returns true once she has collected it
   */
  isCollected(mineral: number): boolean;
  /**
   * Copies everything that changes during a run.
   *
   * @param into - an array to reuse; ignored unless its length is that of a snapshot of this scene
   * @returns the snapshot: `into`, or a new array
   */
  snapshot(into?: Float64Array): Float64Array;
  /**
   * Goes back to a snapshot.
   *
   * @param snapshot - a snapshot of a simulation of the same scene
   * @throws {RangeError} when the snapshot has another length than those of this scene
   */
  restore(snapshot: Float64Array): void;
  /** Goes back to the start and sets {@link Simulation.work} to 0. */
  reset(): void;
}

/** The motion of a run, to be read at any time from its start to its end. */
export interface Trajectory {
  /** Length of the run, s. */
  readonly duration: number;
  /**
   * Writes the state of the astronaut at a time: x, y (px), vx, vy (px/s), cos, sin of the angle of the collision box's x axis.
   *
   * @param time - s from the start; clamped to the run
   * @param out - receives 6 doubles ({@link STATE_SIZE})
   */
  at(time: number, out: Float64Array): void;
  /**
   * Writes x, y (px) and alive (1, or 0 once exploded) of every alien at a time, in the level's order.
   *
   * @param time - s from the start; clamped to the run
   * @param out - receives 3 doubles per alien
   */
  aliensAt(time: number, out: Float64Array): void;
  /**
   * Writes x, y (px) of every asteroid at a time, in the level's order. Recoil moves asteroids.
   *
   * @param time - s from the start; clamped to the run
   * @param out - receives 2 doubles per asteroid
   */
  asteroidsAt(time: number, out: Float64Array): void;
}

/** More than any force can change a path within a tick or two, px. */
const LEAST = 2;

/**
 * Tells whether she was moved from one place to another at once between two states: no flight leads from the first to the
 * second.
 *
 * @param states - states of the astronaut, each beginning with x, y (px), vx, vy (px/s)
 * @param from - index in `states` at which the earlier state begins
 * @param to - index in `states` at which the later state begins
 * @param seconds - time between the two, s; at most a few ticks
 * @returns true if the places differ by more than 2 px from what the velocities allow
 */
export function isJump(states: Float64Array, from: number, to: number, seconds: number): boolean {
  const dx = states[to] - states[from] - ((states[from + 2] + states[to + 2]) / 2) * seconds;
  const dy = states[to + 1] - states[from + 1] - ((states[from + 3] + states[to + 3]) / 2) * seconds;
  return dx * dx + dy * dy > LEAST * LEAST;
}

/**
 * Checks that a snapshot has the length of the state that it is to replace.
 * @throws {RangeError} if it has not
 */
export function expectSnapshot(snapshot: Float64Array, length: number): void {
  if (snapshot.length === length) return;
  throw new RangeError(`expected a snapshot of ${length} numbers of this scene, found ${snapshot.length}`);
}

import type { Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Candidate, Goal } from '../../verified-run.ts';

/** The work done so far. It is the same on every machine. */
export interface Effort {
  /** Stretches that were simulated without a break. */
  readonly runs: number;
  /** Simulated ticks of 1/60 s. */
  readonly ticks: number;
}

/** The closest approach: the smallest distance to the black hole that any run reached. */
export interface Closest {
  /** From her collision box to the rim of the black hole, px; 0 where she reached it without meeting the goal. */
  readonly distance: number;
  /** The tick at which she came so close. */
  readonly tick: number;
  /** The holds that lead there, [press, release) in ticks. */
  readonly holds: readonly Hold[];
}

/** Where a search has been, for a heat map. */
export interface Explored {
  /** Side of a square, px. */
  readonly cellSize: number;
  /** The squares that were visited, in no order. */
  readonly cells: readonly {
    /** x of the centre, px. */
    readonly x: number;
    /** y of the centre, px. */
    readonly y: number;
    /** How often a simulated state fell into the square. */
    readonly visits: number;
  }[];
}

/** What {@link createSearch} looks for. */
export interface SearchOptions {
  /** What a run has to achieve; by default only the black hole. */
  readonly goal?: Goal;
  /** Seed of the random choices, any finite number; 0 by default. */
  readonly seed?: number;
  /** The longest a run may last, ticks; that of the scene by default. */
  readonly maxTicks?: number;
  /** Where the search begins; at the start of the level by default. */
  readonly after?: Moment;
}

/** A moment of a run: the state that holds lead to. */
export interface Moment {
  /** [press, release) in ticks, sorted and disjoint; what comes after `tick` does not count. */
  readonly holds: readonly Hold[];
  /** Ticks since the start. */
  readonly tick: number;
}

/** A search for runs that meet a goal. The caller decides how long it goes on. */
export interface Search {
  /** The scene that is searched. */
  readonly scene: Scene;
  /** The work done so far. */
  readonly effort: Effort;
  /** The closest approach so far; null until something has been simulated. */
  readonly closest: Closest | null;
  /** The runs found, in the order found. A replay from the start has confirmed each of them. */
  readonly solutions: readonly Candidate[];
  /** Where the search has been so far. */
  readonly explored: Explored;
  /**
   * True when there is nothing to try: the goal requires more minerals than the level has, or the run is over where the search
   * begins.
   */
  readonly exhausted: boolean;
  /** The last tick at which she was seen alive, counted from the start of the level. */
  readonly latest: number;
  /**
   * Some of the states that the search has kept, one for each cell of place and velocity, evenly spread over the order in which
   * they were found.
   * @param count how many at most
   */
  moments(count: number): Moment[];
  /**
   * Continues the search. The same total gives the same result however it is split into calls.
   * @param ticks how many more ticks to simulate; the search may overshoot by one stretch
   * @returns how many new solutions it found
   */
  advance(ticks: number): number;
}

import type { Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import type { Candidate } from '../verified-run.ts';

/** What has been simulated so far. */
export interface Effort {
  /** stretches simulated in one go */
  readonly runs: number;
  /** ticks of 1/60 s */
  readonly ticks: number;
}

/** The nearest that any run came to the black hole. */
export interface Closest {
  /** from her box to the black hole's rim, px; 0 where she reached it without meeting the goal */
  readonly distance: number;
  readonly tick: number;
  readonly holds: readonly Hold[];
}

/** Where the search has been, for a heat map: squares of `cellSize` px, `x` and `y` their centres. */
export interface Explored {
  readonly cellSize: number;
  readonly cells: readonly { readonly x: number; readonly y: number; readonly visits: number }[];
}

export interface SearchOptions {
  /** any minerals when left out */
  readonly goal?: Goal;
  /** 0 when left out */
  readonly seed?: number;
  /** how long a run may last, ticks; 3600 when left out */
  readonly maxTicks?: number;
}

/** A search for runs that meet a goal, to be advanced as long as one likes. */
export interface Search {
  readonly scene: Scene;
  readonly effort: Effort;
  /** null until something has been simulated */
  readonly closest: Closest | null;
  /** In the order found, each verified by a replay from the start. */
  readonly solutions: readonly Candidate[];
  readonly explored: Explored;
  /** Nothing can be tried at all: the goal asks for more minerals than there are. */
  readonly exhausted: boolean;
  /**
   * Simulates about so many more ticks. The same total gives the same result however it is split.
   * @returns how many new solutions it found
   */
  advance(ticks: number): number;
}

import type { Scene } from '../../engine/index.ts';
import { cleanRun } from '../clean/index.ts';
import type { Goal } from '../goal.ts';
import { type Closest, createSearch, type Effort, type Explored, HeatTally, type Search } from '../search/index.ts';
import type { Candidate } from '../verified-run.ts';

/** Ticks that a search simulates per call, so that the caller can stop between calls. */
const GO = 500;

/** A later search is abandoned after this many times the cost of the most expensive success, but not before `LEAST_TICKS`. */
const PATIENCE = 4;
const LEAST_TICKS = 100_000;

/** Produces simplified runs from searches that restart with new seeds, so that the runs are independent of each other. */
export class Restarts {
  private readonly scene: Scene;
  private readonly goal: Goal;
  private readonly maxTicks: number;
  private readonly seedOf: (restart: number) => number;
  private readonly first: Search;
  private search: Search;
  private count = 0;
  private mostExpensive = 0;
  private readonly past = new HeatTally();
  private nearest: Closest | null = null;
  private runs = 0;
  private ticks = 0;

  constructor(scene: Scene, goal: Goal, maxTicks: number, seedOf: (restart: number) => number) {
    this.scene = scene;
    this.goal = goal;
    this.maxTicks = maxTicks;
    this.seedOf = seedOf;
    this.first = this.start();
    this.search = this.first;
  }

  get effort(): Effort {
    const { runs, ticks } = this.search.effort;
    return { runs: this.runs + runs, ticks: this.ticks + ticks };
  }

  /** The closest approach of all searches. */
  get closest(): Closest | null {
    const now = this.search.closest;
    return now === null || (this.nearest !== null && this.nearest.distance <= now.distance) ? this.nearest : now;
  }

  /** Where all searches have been. */
  get explored(): Explored {
    return this.past.explored(this.search.explored);
  }

  /** True when there is nothing to try, because the goal requires more minerals than the level has. */
  get exhausted(): boolean {
    return this.first.exhausted;
  }

  /**
   * Continues the search for a while.
   * @returns a run if one was found
   */
  next(): Candidate | null {
    const { search, scene, goal, maxTicks } = this;
    search.advance(GO);
    const found = search.solutions[0];
    if (found === undefined) {
      const limit = Math.max(LEAST_TICKS, PATIENCE * this.mostExpensive);
      if (this.mostExpensive > 0 && search.effort.ticks > limit) this.restart();
      return null;
    }
    this.mostExpensive = Math.max(this.mostExpensive, search.effort.ticks);
    this.restart();
    const cleaned = cleanRun(scene, found.holds, goal, { maxTicks });
    if (cleaned === null) return null;
    this.runs += cleaned.effort.runs;
    this.ticks += cleaned.effort.ticks;
    return cleaned.run;
  }

  private start(): Search {
    return createSearch(this.scene, { goal: this.goal, maxTicks: this.maxTicks, seed: this.seedOf(this.count++) });
  }

  private restart(): void {
    this.nearest = this.closest;
    this.past.add(this.search.explored);
    this.runs += this.search.effort.runs;
    this.ticks += this.search.effort.ticks;
    this.search = this.start();
  }
}

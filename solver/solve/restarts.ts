import type { Scene } from '../../engine/index.ts';
import { cleanRun } from '../clean/index.ts';
import type { Goal } from '../goal.ts';
import { type Closest, createSearch, type Effort, type Explored, HeatTally, type Search } from '../search/index.ts';
import type { Candidate } from '../verified-run.ts';

/** Ticks a search simulates in one go: between two goes somebody may stop it. */
const GO = 500;

/** A search after the first gets so many times what the most expensive success took, and this many ticks at least, before it is given up. */
const PATIENCE = 4;
const LEAST_TICKS = 100_000;

/** Runs out of searches that start afresh with other seeds, so that each is found in its own way; cleaned. */
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

  /** The nearest that any of them came. */
  get closest(): Closest | null {
    const now = this.search.closest;
    return now === null || (this.nearest !== null && this.nearest.distance <= now.distance) ? this.nearest : now;
  }

  /** Where all of them have been. */
  get explored(): Explored {
    return this.past.explored(this.search.explored);
  }

  /** Nothing can be found, however long it is sought. */
  get exhausted(): boolean {
    return this.first.exhausted;
  }

  /** Searches a little. @returns a run once one is found */
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

import type { RunEnd } from '../../../check/words/index.ts';
import {
  compile,
  createSimulation,
  type Ending,
  maxTicksOf,
  playScript,
  type Run,
  type Scene,
  simulate,
  type Terms,
  TICK,
  unlimited,
  WorkBudget,
  WorkLimitReached,
} from '../../../engine/index.ts';
import type { Hold, Level, LevelFile } from '../../../schema/index.ts';
import { March } from './march.ts';
import type { MarchRoom } from './march-room.ts';

/** ticks between two readings of the clock */
const STRIDE = 60;

/** How a run ended. @param maxTicks after which it is a timeout */
export const toEnd = (ending: Ending | null, maxTicks: number): RunEnd =>
  ending ?? { outcome: 'timeout', with: null, time: maxTicks * TICK, tick: maxTicks };

/** How a run ends, and what it costs to simulate it from the start. */
export interface CountedEnd extends RunEnd {
  /** in looks, of which a {@link WorkBudget} counts its work */
  readonly looks: number;
}

/** A run in full, with the same cost. */
interface CountedRun {
  readonly run: Run;
  readonly looks: number;
}

/** Everything known about one scene: runs by their holds. */
export class SceneRecord {
  readonly scene: Scene;
  readonly march: March;
  /** The work limit per answer. */
  readonly budget: WorkBudget;
  /** The longest a run may last, ticks. */
  readonly maxTicks: number;
  private readonly ends = new Map<string, CountedEnd>();
  private readonly fulls = new Map<string, CountedRun>();

  constructor(
    readonly file: LevelFile,
    readonly level: Level,
    readonly terms: Terms,
    room: MarchRoom,
    /** pieces of motion per answer */
    readonly work: number,
  ) {
    this.scene = compile(level, terms);
    this.maxTicks = maxTicksOf(terms);
    this.budget = new WorkBudget(work, Number.POSITIVE_INFINITY);
    this.march = new March(this.scene, this.maxTicks, room, this.budget);
  }

  /** How a script ends; nothing else is recorded. @param holds sorted and disjoint @returns null if it was stopped */
  end(holds: readonly Hold[], isLate: () => boolean): CountedEnd | null {
    const key = holds.join();
    const known = this.ends.get(key);
    if (known !== undefined) return known;
    const { maxTicks } = this;
    const before = this.budget.looks;
    try {
      const simulation = createSimulation(this.scene, this.budget);
      while (simulation.ending === null && simulation.tick < maxTicks) {
        if (isLate()) return null;
        playScript(simulation, holds, Math.min(maxTicks, simulation.tick + STRIDE));
      }
      const end = { ...toEnd(simulation.ending, maxTicks), looks: this.budget.looks - before };
      this.ends.set(key, end);
      return end;
    } catch (error) {
      if (error instanceof WorkLimitReached) return null;
      throw error;
    }
  }

  /** A run with its events and hash, and its cost, which nothing limits. */
  full(holds: readonly Hold[]): CountedRun {
    const key = holds.join();
    const known = this.fulls.get(key);
    if (known !== undefined) return known;
    const budget = unlimited();
    const run = simulate(this.scene, holds, { budget });
    const counted = { run, looks: budget.looks };
    // dragging a hold requests a new run each time
    if (this.fulls.size > 64) this.fulls.clear();
    this.fulls.set(key, counted);
    return counted;
  }
}

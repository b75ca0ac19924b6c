import { type Accuracy, maxTicksOf, type Terms, TICK, termsOf } from '../../engine/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import type { Proof } from '../proofs/index.ts';
import type { Effort } from '../search/index.ts';
import type { Proposal } from './proposal.ts';
import { repairSteps } from './repair-steps.ts';
import { Task } from './task.ts';

/** What {@link createRepair} looks for. */
export interface RepairOptions {
  /** How many proposals of different kinds are wanted; 3 by default. */
  readonly count?: number;
  /** Seed of the searches, a whole number; 0 by default. */
  readonly seed?: number;
  /** The longest a run may last, ticks; that of the terms by default. */
  readonly maxTicks?: number;
  /** A proof that the level cannot be completed. It directs the repair, and saves a search of the level as it is. */
  readonly proof?: Proof | null;
}

/** A search for small changes that make a level completable. It can be stopped at any time, and has its best proposals so far. */
export interface Repair {
  /** The work done so far. */
  readonly effort: Effort;
  /**
   * The best proposals so far, the smallest first: at most `count`, each of another kind. A replay from the start has confirmed
   * each of them.
   */
  readonly proposals: readonly Proposal[];
  /** Index of a run of the level that completes it as it is, so that there is nothing to repair; null if there is none. */
  readonly completing: number | null;
  /** True when nothing more is tried. */
  readonly finished: boolean;
  /**
   * Continues the work. The same total gives the same result however it is split into calls.
   * @param ticks how many more ticks to simulate; the repair may overshoot by one search
   */
  advance(ticks: number): void;
}

/**
 * Creates a search for the smallest change that makes a level completable. It simulates nothing before the first call of
 * `advance`.
 *
 * It changes one thing at a time: a place, a radius, the range, her velocity at the start, or it removes an object. Each change
 * that is found is made smaller as far as the run still completes the level, so it is the smallest that was found along its
 * way, not the smallest that there is.
 * @param level the level, with its runs
 * @param under the terms under which a run has to complete it; or only an accuracy, with the default terms for the rest
 * @param options the number of proposals, the seed and a proof that the level is impossible
 * @returns a repair at its start
 * @example
 * ```ts
 * import { ACCURACIES } from 'gravity-quest-toolkit';
 * import { applyChange, createRepair } from 'gravity-quest-toolkit/solver';
 *
 * const repair = createRepair(level, ACCURACIES.precise);
 * while (!repair.finished && repair.effort.ticks < 5_000_000) repair.advance(50_000);
 * const [best] = repair.proposals;
 * if (best?.change) console.log(best.size, applyChange(level, best.change));
 * ```
 */
export function createRepair(level: Level, under: Accuracy | Terms, options: RepairOptions = {}): Repair {
  const { count = 3, seed = 0, maxTicks = maxTicksOf(termsOf(under)), proof = null } = options;
  const task = new Task(level, { ...termsOf(under), maxTime: maxTicks * TICK }, { count, seed, proof });
  const work = repairSteps(task);
  let asked = 0;
  let finished = false;
  return {
    get effort() {
      return { runs: task.trials.runs, ticks: task.trials.ticks };
    },
    get proposals() {
      return task.best();
    },
    get completing() {
      return task.completing;
    },
    get finished() {
      return finished;
    },
    advance(ticks) {
      asked += ticks;
      while (!finished && task.trials.ticks < asked) finished = work.next().done === true;
    },
  };
}

import { isAccuracyName, maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Proof } from '../../prove/index.ts';
import type { Closest, Effort, Explored } from '../explore/index.ts';
import { createSolver, type Solution, type SolveOptions, type Solver } from '../solve/index.ts';
import { type AnytimeProof, createAnytimeProof } from './anytime-proof.ts';

/** What a {@link Decider} looks for. */
export interface DeciderOptions extends SolveOptions {
  /** The most work of both together, ticks; no limit by default. */
  readonly effort?: number;
  /** Asked from time to time during an attempt to prove, which is given up when it returns true. By default none is. */
  readonly isStopped?: () => boolean;
}

/** A search for a run and for a proof that there is none, side by side. */
export interface Decider {
  /** The best run so far; null if there is none. */
  readonly best: Solution | null;
  /** The proof that there is no run, confirmed by the separate checker; null if there is none. */
  readonly impossible: Proof | null;
  /** The work of both so far. */
  readonly effort: Effort;
  /** The closest approach so far; null until something has been simulated. */
  readonly closest: Closest | null;
  /** Where the search has been so far. */
  readonly explored: Explored;
  /** True when nothing can get better, nothing can be found, it is proved that there is no run, or the effort is spent. */
  readonly finished: boolean;
  /**
   * Continues the work. The same total gives nearly the same result however it is split; the same slices give the same.
   * @param ticks how many more ticks to spend; an attempt to prove may exceed that, but not the effort
   */
  advance(ticks: number): void;
}

/**
 * Creates a search for a run and for a proof that there is none. As long as there is no run, the proofs may do as much work as the
 * search; afterwards only the search goes on. For a custom setting of the accuracy there are no proofs.
 *
 * The quick provers of `proveImpossible` are not tried, so call that first.
 * @param scene the compiled level
 * @param options the goal, the objective, the seed and the number of solutions
 * @returns the search at its start; it does nothing before the first call of `advance`
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { createDecider } from 'gravity-quest-toolkit/solver';
 *
 * const decider = createDecider(compile(level), { objective: 'first', effort: 5_000_000 });
 * while (!decider.finished) decider.advance(50_000);
 * console.log(decider.best?.holds ?? decider.impossible?.reason ?? decider.closest);
 * ```
 */
export function createDecider(scene: Scene, options: DeciderOptions = {}): Decider {
  const { goal, maxTicks = maxTicksOf(scene.terms), isStopped } = options;
  const { name } = scene.accuracy;
  const proving = isAccuracyName(name) ? createAnytimeProof(scene.level, { accuracy: name, goal, maxTicks, isStopped }) : null;
  return sideBySide(createSolver(scene, options), proving, options);
}

/** A search for a run and one for a proof, side by side. @param proving null: there are no proofs */
export function sideBySide(
  solver: Pick<Solver, 'advance' | 'best' | 'closest' | 'effort' | 'explored' | 'finished'>,
  proving: Pick<AnytimeProof, 'advance' | 'finished' | 'proof' | 'ticks'> | null,
  { effort = Number.POSITIVE_INFINITY, isStopped }: Pick<DeciderOptions, 'effort' | 'isStopped'> = {},
): Decider {
  const spent = (): number => solver.effort.ticks + (proving?.ticks ?? 0);
  const isProved = (): boolean => solver.best === null && proving?.proof != null;
  const isOver = (): boolean => isProved() || solver.finished || spent() >= effort;
  // what the proofs may have spent so far
  let given = 0;
  return {
    get best() {
      return solver.best;
    },
    get impossible() {
      return solver.best === null ? (proving?.proof ?? null) : null;
    },
    get effort() {
      return { runs: solver.effort.runs, ticks: spent() };
    },
    get closest() {
      return solver.closest;
    },
    get explored() {
      return solver.explored;
    },
    get finished() {
      return isOver();
    },
    advance(ticks) {
      const end = Math.min(effort, spent() + ticks);
      // at least once, so that known runs are tried
      do {
        solver.advance(Math.max(1, Math.min(SLICE, end - spent())));
        if (proving === null || proving.finished || solver.best !== null) continue;
        const may = proofShare(solver.effort.ticks, effort);
        if (may > given) proving.advance(may - given);
        given = Math.max(given, may);
      } while (spent() < end && !isOver() && isStopped?.() !== true);
    },
  };
}

/** Ticks of the search before the proofs may catch up. */
const SLICE = 50_000;

/**
 * How much work a search for a proof may have done beside a search for a run: as much as that, and both together no more than the
 * effort.
 * @param search the work of the search for a run so far, ticks
 * @param effort the most work of both together, ticks; infinite for no limit
 * @returns ticks
 */
export const proofShare = (search: number, effort: number): number => Math.max(0, Math.min(search, effort - search));

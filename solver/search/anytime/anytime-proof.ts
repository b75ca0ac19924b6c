import { type AccuracyName, DEFAULT_MAX_TICKS, TICK, WorkBudget } from '../../../engine/index.ts';
import type { Level } from '../../../schema/basics/index.ts';
import { type About, mayProve, type Proof, type Prover, proveBy } from '../../prove/index.ts';
import { type Goal, mineralsNeeded } from '../../verified-run.ts';
import { verifyProof } from '../../verify/index.ts';

/** For which runs an {@link AnytimeProof} is sought. */
export interface AnytimeOptions {
  /** The accuracy that the proof has to cover. */
  readonly accuracy: AccuracyName;
  /** What a run has to achieve; by default only the black hole. */
  readonly goal?: Goal;
  /** The longest a run may last, ticks; 3600 by default. */
  readonly maxTicks?: number;
  /** Asked from time to time during an attempt, which is given up when it returns true. By default no attempt is. */
  readonly isStopped?: () => boolean;
  /** The provers that may be tried; all by default. */
  readonly provers?: readonly Prover[];
}

/** A search for a proof that goes on for as long as it is given work. */
export interface AnytimeProof {
  /** The proof that no run reaches the goal, confirmed by {@link verifyProof}; null until there is one. */
  readonly proof: Proof | null;
  /** True when there is a proof, or nothing finer is left to try. */
  readonly finished: boolean;
  /** The work done so far, in ticks of a search that take about as long. */
  readonly ticks: number;
  /** The most work that the next attempt may take, ticks; 0 when it is finished. */
  readonly nextLimit: number;
  /** Makes the next attempt, however little work has been asked for. */
  attempt(): void;
  /**
   * Continues the work. The same total gives the same result however it is split into calls: an attempt is made once the total
   * covers its limit.
   * @param ticks how much more work to do; less is done as long as it does not suffice for the next attempt
   */
  advance(ticks: number): void;
}

/**
 * What is tried, one after the other: the provers that prove more with finer sets. `doomed` and `flowpipe` begin finer than quick
 * proofs do, which seldom lack work for them. The limits are what the larger of the attempts take that succeed, ticks; short
 * attempts come first, because where she is lost quickly, a fine grid may take less work than a coarse one.
 */
const ATTEMPTS: readonly Pick<Attempt, 'prover' | 'fineness' | 'limit'>[] = [
  { prover: 'orbits', fineness: 0, limit: 500_000 },
  { prover: 'orbits', fineness: 3, limit: 500_000 },
  { prover: 'orbits', fineness: 0, limit: 3_000_000 },
  { prover: 'flowpipe', fineness: 1, limit: 2_000_000 },
  { prover: 'doomed', fineness: 1, limit: 2_000_000 },
  { prover: 'orbits', fineness: 2, limit: 8_000_000 },
  { prover: 'orbits', fineness: 1, limit: 8_000_000 },
  { prover: 'orbits', fineness: 3, limit: 24_000_000 },
];

/** With more minerals than this, only the black hole is examined. */
const MOST_MINERALS = 3;

/** Looks at the state between two questions whether to stop. */
const ASK_EVERY = 200_000;

/** A limit on the work of one attempt that also ends it on request. */
class StoppableBudget extends WorkBudget {
  /** Whether a request ended it. */
  wasStopped = false;
  private readonly isStopped: () => boolean;
  private askAt = ASK_EVERY;

  constructor(looks: number, isStopped: () => boolean) {
    super(looks / 16);
    this.isStopped = isStopped;
  }

  override look(count: number): void {
    super.look(count);
    if (this.looks < this.askAt) return;
    this.askAt = this.looks + ASK_EVERY;
    this.wasStopped = this.isStopped();
    if (this.wasStopped) this.end();
  }
}

interface Attempt {
  readonly prover: Prover;
  readonly about: About;
  readonly fineness: number;
  /** The most work, ticks. */
  readonly limit: number;
}

function aboutsOf({ minerals }: Level, goal: Goal): About[] {
  const needed = mineralsNeeded(goal, minerals.length);
  const areAllNeeded = needed > 0 && needed === minerals.length && needed <= MOST_MINERALS;
  return [{ kind: 'blackHole' }, ...(areAllNeeded ? minerals.map((_, index): About => ({ kind: 'mineral', index })) : [])];
}

/** What makes and checks proofs. */
export interface ProofParts {
  readonly mayProve: typeof mayProve;
  readonly proveBy: typeof proveBy;
  readonly verifyProof: typeof verifyProof;
}

/**
 * Creates a search for a proof that a goal is out of reach, with ever finer sets. The quick provers of `proveImpossible` are not
 * repeated, so call that first. It does nothing before the first call of `advance`.
 * @param level the level
 * @param options the accuracy, the goal and the longest run
 * @returns the search at its start
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { createAnytimeProof, createSolver } from 'gravity-quest-toolkit/solver';
 *
 * const solver = createSolver(compile(level), { objective: 'first' });
 * const proving = createAnytimeProof(level, { accuracy: 'precise' });
 * while (!solver.finished && proving.proof === null && solver.effort.ticks < 5_000_000) {
 *   solver.advance(50_000);
 *   proving.advance(50_000);
 * }
 * ```
 */
export function createAnytimeProof(level: Level, options: AnytimeOptions): AnytimeProof {
  return anytimeProofBy({ mayProve, proveBy, verifyProof }, level, options);
}

/** {@link createAnytimeProof} with other provers or another checker. */
export function anytimeProofBy(parts: ProofParts, level: Level, options: AnytimeOptions): AnytimeProof {
  const { accuracy, goal = { minerals: 'any' }, maxTicks = DEFAULT_MAX_TICKS, isStopped = () => false } = options;
  const maxTime = maxTicks * TICK;
  const abouts = aboutsOf(level, goal);
  let attempts = ATTEMPTS.filter(
    ({ prover, fineness }) =>
      (options.provers?.includes(prover) ?? true) && parts.mayProve(prover, level, { accuracy, maxTime, fineness }),
  ).flatMap((attempt) => abouts.map((about): Attempt => ({ ...attempt, about })));
  let proof: Proof | null = null;
  let asked = 0;
  let spent = 0;

  const next = (): Attempt | null => (proof === null ? (attempts[0] ?? null) : null);

  function make({ prover, about, fineness, limit }: Attempt): void {
    attempts.shift();
    const budget = new StoppableBudget(limit, isStopped);
    const found = parts.proveBy(prover, level, about, { accuracy, maxTime, budget, fineness });
    spent += Math.min(limit, Math.max(1, Math.ceil(budget.looks)));
    if (found !== null && parts.verifyProof(level, found).ok) proof = found;
    // it ended by itself, so it would end in the same way with more work
    if (!budget.isUsedUp && !budget.wasStopped) {
      const isSame = (other: Attempt) => other.prover === prover && other.fineness === fineness && other.about === about;
      attempts = attempts.filter((other) => !isSame(other));
    }
  }

  return {
    get proof() {
      return proof;
    },
    get finished() {
      return next() === null;
    },
    get ticks() {
      return spent;
    },
    get nextLimit() {
      return next()?.limit ?? 0;
    },
    attempt() {
      const attempt = next();
      if (attempt !== null) make(attempt);
      asked = Math.max(asked, spent);
    },
    advance(ticks) {
      asked += ticks;
      for (let attempt = next(); attempt !== null && spent + attempt.limit <= asked && !isStopped(); attempt = next()) {
        make(attempt);
      }
    },
  };
}

import { type AccuracyName, compile, DEFAULT_MAX_WORK, type Scene, WorkBudget } from '../../engine/index.ts';
import { createDecider, createSearch, proveImpossible, verifyProof } from '../../solver/index.ts';
import { type NamedLevel, processorClock } from '../harness/index.ts';

/** What was found out about one level. */
export interface Decision {
  readonly name: string;
  readonly verdict: 'completable' | 'impossible' | 'undecided';
  /** The code of the proof, or what went wrong with it. */
  readonly proof: string | null;
  /** Ticks of search and proofs together. */
  readonly ticks: number;
  /** Ticks of the search that was to refute a proof. */
  readonly refutingTicks: number;
  /** Closest approach, px; null when nothing was searched. */
  readonly closest: number | null;
  /** Squares of 32 px that the search reached. */
  readonly squares: number;
  /** Processor time of search and longer proofs together, ms. */
  readonly searchMs: number;
  /** Processor time of the quick provers, ms. */
  readonly proofMs: number;
  /** Processor time of the checker, ms. */
  readonly verifyMs: number;
}

/** How much is tried on each level. */
export interface Effort {
  readonly accuracy: AccuracyName;
  /** Ticks of search and proofs together, for a level that no quick proof settles. */
  readonly budget: number;
  /** Processor time to search a level that is proved impossible, ms; 0 for no search. */
  readonly refuteMs: number;
}

// ticks between two readings of the clock
const SLICE = 50_000;

/** A level in which a search reaches no more squares than this ends quickly whatever is pressed. */
export const FEW_SQUARES = 40;

/** Tries to prove a level impossible, and searches it when that fails, or to refute the proof. */
export function decide({ name, level }: NamedLevel, { accuracy, budget, refuteMs }: Effort): Decision {
  const proving = processorClock();
  // as `gq check` does
  const quick = proveImpossible(level, { accuracy, budget: new WorkBudget(DEFAULT_MAX_WORK / 2) });
  const proofMs = proving();
  const searching = processorClock();
  const scene = compile(level, accuracy);
  const decider = createDecider(scene, { objective: 'first', seed: 0, effort: budget });
  while (quick === null && !decider.finished) decider.advance(SLICE);
  const proof = quick ?? decider.impossible;
  const searchMs = searching();
  const verifying = processorClock();
  const verification = proof === null ? null : verifyProof(level, proof);
  const verifyMs = verifying();
  const refuted = proof !== null && refuteMs > 0 ? refute(scene, refuteMs) : null;
  const found = decider.best !== null || refuted?.isFound === true;
  const wrong =
    verification !== null && !verification.ok ? `unverified: ${verification.why}` : found && proof !== null ? 'REFUTED' : null;
  return {
    name,
    verdict: found ? 'completable' : proof !== null && wrong === null ? 'impossible' : 'undecided',
    proof: wrong ?? proof?.code ?? null,
    ticks: decider.effort.ticks,
    refutingTicks: refuted?.ticks ?? 0,
    closest: decider.closest?.distance ?? null,
    squares: decider.explored.cells.length,
    searchMs,
    proofMs,
    verifyMs,
  };
}

/** Searches a level that is said to be impossible. */
function refute(scene: Scene, ms: number): { isFound: boolean; ticks: number } {
  const search = createSearch(scene, { seed: 1 });
  const spent = processorClock();
  // a search may run out of work: it is not continued once it no longer advances
  for (let before = -1; search.solutions.length === 0 && search.effort.ticks > before && spent() < ms; ) {
    before = search.effort.ticks;
    search.advance(SLICE);
  }
  return { isFound: search.solutions.length > 0, ticks: search.effort.ticks };
}

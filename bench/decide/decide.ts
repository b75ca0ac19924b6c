import { type AccuracyName, compile } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { createSearch, proveImpossible, verifyProof } from '../../solver/index.ts';

/** A level to decide, with a name by which reports call it. */
export interface NamedLevel {
  readonly name: string;
  readonly level: Level;
}

/** What was found out about one level. */
export interface Decision {
  readonly name: string;
  readonly verdict: 'completable' | 'impossible' | 'undecided';
  /** The code of the proof, or what went wrong with it. */
  readonly proof: string | null;
  /** Ticks searched. */
  readonly ticks: number;
  /** Closest approach, px; null when nothing was searched. */
  readonly closest: number | null;
  /** Squares of 32 px that the search reached. */
  readonly squares: number;
  /** Processor time of the search, ms. */
  readonly searchMs: number;
  /** Processor time of the proof, ms. */
  readonly proofMs: number;
  /** Processor time of the checker, ms. */
  readonly verifyMs: number;
}

/** How much is tried on each level. */
export interface Effort {
  readonly accuracy: AccuracyName;
  /** Ticks of one search of a level that no proof settles. */
  readonly budget: number;
  /** Number of searches, each with its own seed, if the first one gets far. */
  readonly searches: number;
  /** Processor time to search a level that is proved impossible, ms; 0 for no search. */
  readonly refuteMs: number;
}

// ticks between two readings of the clock
const SLICE = 50_000;

/**
 * A search that reaches no more squares than this ends quickly whatever it presses, so another search would tell nothing new.
 */
export const FEW_SQUARES = 40;

const milliseconds = (since: NodeJS.CpuUsage): number => {
  const { user, system } = process.cpuUsage(since);
  return (user + system) / 1000;
};

/** Tries to prove a level impossible, and searches it when that fails, or to refute the proof. */
export function decide({ name, level }: NamedLevel, { accuracy, budget, searches, refuteMs }: Effort): Decision {
  const began = process.cpuUsage();
  const proof = proveImpossible(level, { accuracy });
  const proofMs = milliseconds(began);
  const checked = process.cpuUsage();
  const verification = proof === null ? null : verifyProof(level, proof);
  const verifyMs = milliseconds(checked);
  const from = process.cpuUsage();
  const scene = compile(level, accuracy);
  let search = createSearch(scene, { seed: 0 });
  let ticks = 0;
  for (let one = 0; one < (proof === null ? searches : 1); one++) {
    if (one > 0) search = createSearch(scene, { seed: one });
    const isOn = (): boolean => (proof === null ? search.effort.ticks < budget : refuteMs > 0 && milliseconds(from) < refuteMs);
    // a search may run out of work: it is not continued once it no longer advances
    for (let before = -1; search.solutions.length === 0 && search.effort.ticks > before && isOn(); ) {
      before = search.effort.ticks;
      search.advance(Math.min(SLICE, proof === null ? budget - before : SLICE));
    }
    ticks += search.effort.ticks;
    if (search.solutions.length > 0 || search.explored.cells.length <= FEW_SQUARES) break;
  }
  const found = search.solutions.length > 0;
  const wrong =
    verification !== null && !verification.ok ? `unverified: ${verification.why}` : found && proof !== null ? 'REFUTED' : null;
  return {
    name,
    verdict: found ? 'completable' : proof !== null && wrong === null ? 'impossible' : 'undecided',
    proof: wrong ?? proof?.code ?? null,
    ticks,
    closest: search.closest?.distance ?? null,
    squares: search.explored.cells.length,
    searchMs: milliseconds(from),
    proofMs,
    verifyMs,
  };
}

import { type AccuracyName, compile } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import { createSearch, type Goal } from '../solver/index.ts';
import { processorClock } from './harness/index.ts';

/** How long a search took to its first run. */
export interface TimedSearch {
  /** Processor time, ms, so that other work on the machine matters little. */
  readonly ms: number;
  /** Ticks simulated. */
  readonly ticks: number;
  /** Whether a run was found. */
  readonly found: boolean;
  /** Presses of the first run. */
  readonly presses: number;
}

/** Ticks between two readings of the clock. */
const SLICE = 500;

/**
 * Searches until there is a run or `mostMs` are over. The scene is made before the clock starts, the search afterwards.
 * @param repeats - repetitions; a search is deterministic, so the least time is that of an undisturbed one
 */
export function timeSearch(
  level: Level,
  accuracy: AccuracyName,
  goal: Goal,
  seed: number,
  mostMs: number,
  repeats: number,
): TimedSearch {
  const scene = compile(level, accuracy);
  let best: TimedSearch | null = null;
  for (let i = 0; i < repeats; i++) {
    const spent = processorClock();
    const search = createSearch(scene, { goal, seed });
    // a reading of the clock costs as much as a slice, so readings become less frequent the longer the search takes
    for (let slices = 1; search.solutions.length === 0; slices++) {
      search.advance(SLICE);
      if (search.exhausted || (slices % 64 === 0 && spent() > mostMs)) break;
    }
    const ms = spent();
    if (best !== null && ms >= best.ms) continue;
    const [first] = search.solutions;
    best = { ms, ticks: search.effort.ticks, found: first !== undefined, presses: first?.holds.length ?? 0 };
    if (ms > mostMs / 10) break;
  }
  if (best === null) throw new RangeError(`expected at least one repeat, found ${repeats}`);
  return best;
}

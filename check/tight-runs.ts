import { joinHolds, type Scene } from '../engine/index.ts';
import type { Hold, Level } from '../schema/index.ts';
import { certify } from '../solver/index.ts';
import type { RunEnd } from './words/index.ts';

/** Runs simulated at most to certify a run: where they don't suffice, what was asked for is not proved. */
export const MOST_RUNS = 200_000;

/** A run that completes the level. */
export interface CompletingRun {
  readonly holds: readonly Hold[];
  /** as a sentence begins */
  readonly name: string;
  readonly pointer: string;
}

/** A run that forgives less than it should. */
export interface TightRun extends CompletingRun {
  /** Ticks that were required; null: nothing was, and it forgives nothing. */
  readonly required: number | null;
  /** Ticks by which all its presses and releases may be off, in every combination. */
  readonly ticks: number;
  /** A combination of one tick more that fails; null: none was found. */
  readonly counterexample: readonly Hold[] | null;
  /** There were too many combinations to try: more ticks may be forgiven. */
  readonly isExhausted: boolean;
}

/** Every run that completes a level: scripted ones, and the one that was found. @param ends how the level's own end */
export function completingRuns(
  level: Level,
  ends: readonly Pick<RunEnd, 'outcome'>[],
  found: readonly Hold[] | null,
): CompletingRun[] {
  const runs = level.runs.flatMap(({ name, holds }, i): CompletingRun[] =>
    ends[i].outcome === 'completed' ? [{ holds, name: `run ${JSON.stringify(name)}`, pointer: `/runs/${i}` }] : [],
  );
  return found === null ? runs : [...runs, { holds: found, name: 'the run that was found', pointer: '' }];
}

/**
 * Those that forgive less than so many ticks, or nothing where no number is required. Simulates every combination of shifts.
 */
export function tightRuns(scene: Scene, runs: readonly CompletingRun[], required: number | null): TightRun[] {
  const wanted = wantedTicks(required);
  return runs.flatMap((run): TightRun[] => {
    const { ticks, exhausted, counterexample } = certify(
      scene,
      run.holds,
      { minerals: 'any' },
      { limit: wanted, maxRuns: MOST_RUNS },
    );
    if (ticks >= wanted) return [];
    const example = counterexample === null ? null : joinHolds(counterexample);
    return [{ ...run, required, ticks, counterexample: example, isExhausted: exhausted }];
  });
}

/** What is looked for where nothing is required: a run that forgives nothing. */
export const wantedTicks = (required: number | null): number => required ?? 1;

import { joinHolds, type Scene, WorkBudget } from '../engine/index.ts';
import type { Hold, Level } from '../schema/index.ts';
import { certify } from '../solver/index.ts';
import { withinWork } from './within-work.ts';
import type { RunEnd } from './words/index.ts';

/** The most runs to simulate for one certificate. If they do not suffice, the required ticks are not proved. */
export const MOST_RUNS = 200_000;

/** A run that completes the level. */
interface CompletingRun {
  /** The holds of the run, [press, release) in ticks. */
  readonly holds: readonly Hold[];
  /** What to call the run at the beginning of a sentence. */
  readonly name: string;
  /** JSON pointer to the run in the level file; empty for a run that a search found. */
  readonly pointer: string;
}

/** A run with fewer certified ticks than required. */
export interface TightRun extends CompletingRun {
  /** The required ticks; null when nothing is required and the run has no certified tick at all. */
  readonly required: number | null;
  /** Certified ticks: how far all its presses and releases may move at once. */
  readonly ticks: number;
  /** A failing combination of shifts by one tick more; null when none was found. */
  readonly counterexample: readonly Hold[] | null;
  /** True when there were too many combinations to try, so that more ticks may be possible. */
  readonly isExhausted: boolean;
}

/**
 * Lists every run that completes a level.
 * @param level the level
 * @param ends how its own runs end, in the order of its list
 * @param found the holds of a run that a search found, or null
 * @returns the level's completing runs, then the found one
 */
export function completingRuns(
  level: Level,
  ends: readonly Pick<RunEnd, 'outcome'>[],
  found: readonly Hold[] | null,
): CompletingRun[] {
  const runs = level.runs.flatMap(({ name, holds }, i): CompletingRun[] =>
    ends[i].outcome === 'completed' ? [{ holds, name: `run ${JSON.stringify(name)}`, pointer: `/runs/${i}` }] : [],
  );
  return found === null ? runs : [...runs, { holds: found, name: 'the run that a search found', pointer: '' }];
}

/**
 * Finds the runs with fewer certified ticks than required, or with none at all when nothing is required. Simulates every
 * combination of shifts.
 * @param scene the compiled level
 * @param runs runs that complete the level
 * @param required the certified ticks that each run should have; null requires nothing and looks for 1
 * @returns the runs that fall short
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

/** The certified ticks to look for: at least one, so that runs without any slack are found when nothing is required. */
export const wantedTicks = (required: number | null): number => required ?? 1;

/** The most runs to simulate for one level: a tenth of what a person who asks for one level gets. */
const LOCK_RUNS = 1000;

/** Ticks beyond this are not counted: no player needs more than a sixth of a second. */
const LOCK_TICKS = 10;

/**
 * Measures by how many ticks all presses and releases of a run may move, as a lock records it. The limits count work and not
 * time, so the result is the same on every machine; where they end the measurement, it is a lower bound. It may cost half of the work that the level may.
 * @param scene the compiled level
 * @param holds a run that completes the level
 * @returns the certified ticks, at most 10; null when the work does not suffice
 */
export function ticksToAgree(scene: Scene, holds: readonly Hold[]): number | null {
  const budget = new WorkBudget(scene.terms.maxWork / 2);
  const certified = withinWork(budget, () =>
    certify(scene, holds, { minerals: 'any' }, { limit: LOCK_TICKS, maxRuns: LOCK_RUNS, budget }),
  );
  return certified?.ticks ?? null;
}

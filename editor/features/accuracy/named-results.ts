import { useEffect, useState } from 'react';
import type { RunEnd } from '../../../check/words/index.ts';
import { ACCURACIES, type AccuracyName, compile, createSimulation, maxTicksOf, type Terms } from '../../../engine/index.ts';
import { deviationOf, pathOf, playerOf, type Reference } from '../../../engine/work-precision/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { inSlices } from '../../core/ask/index.ts';
import { useLevel } from '../../core/context/index.ts';
import { timeInTurns } from '../../core/figures/index.ts';
import { type PlayedFile, playsAlike } from '../../core/proof/index.ts';
import { termsAt } from '../../core/terms/index.ts';

/** The result of a run at a named setting. */
export interface NamedResult {
  readonly name: AccuracyName;
  readonly end: RunEnd;
  /** The largest distance to `precise` at any tick before either ends, px. */
  readonly difference: number;
  /** Whether it ends as with `precise`. */
  readonly sameVerdict: boolean;
}

/** in display order */
export const NAMES = Object.keys(ACCURACIES) as readonly AccuracyName[];

/** Simulates a run at every named setting, with the other terms as they are, one per step; `precise` comes first, as the others are compared with it. */
export function* compareNamed(level: Level, terms: Terms, holds: readonly Hold[]): Generator<NamedResult, void, void> {
  const maxTicks = maxTicksOf(terms);
  let reference: Reference | null = null;
  for (const name of ['precise', ...NAMES.filter((other) => other !== 'precise')] as const) {
    const path = pathOf(createSimulation(compile(level, termsAt(terms, name))), holds, maxTicks);
    const ending = path.ending ?? { outcome: 'timeout' as const, with: null, time: terms.maxTime, tick: maxTicks };
    reference ??= { tolerance: ACCURACIES.precise.tolerance, path, outcome: ending.outcome, time: ending.time, floor: 0 };
    const { error, sameVerdict } = deviationOf(path, reference, maxTicks);
    yield { name, end: ending, difference: error, sameVerdict };
  }
}

/** Microseconds per simulated second, by the name of the setting. */
type Costs = ReadonlyMap<AccuracyName, number>;

/** The cost of the named settings on a run, timed in turns; the minimum of the rounds counts. */
function* costsOfNamed(level: Level, terms: Terms, holds: readonly Hold[]): Generator<null, Costs, void> {
  const players = NAMES.map((name) => playerOf([{ level, holds }], ACCURACIES[name], maxTicksOf(terms)));
  const samples = yield* timeInTurns(players, () => performance.now());
  return new Map(NAMES.map((name, i) => [name, Math.min(...samples[i])]));
}

// on the page, while the run changes

/** ms without a change before a run is compared again */
const REST = 200;
/** ms after the comparison before the costs are measured */
const CALM = 300;

interface NamedResults {
  readonly results: readonly NamedResult[];
  /** null until they are measured */
  readonly costs: Costs | null;
  /** Whether all results belong to the current run. */
  readonly isFresh: boolean;
}

/** Compares the named settings on the shown run, in small steps so that the page stays responsive. */
export function useNamedResults(): NamedResults {
  const { proof } = useLevel();
  const [state, setState] = useState<NamedResults>({ results: [], costs: null, isFresh: false });
  useEffect(() => {
    let last: (PlayedFile & { readonly holds: string; readonly maxTime: number }) | null = null;
    let cancel = () => {};
    /** @returns whether the page simulates the run to its end */
    function* compare(): Generator<NamedResult, boolean, void> {
      const { level, terms, run, limit } = proof.proof();
      if (limit !== null) return false;
      yield* compareNamed(level, terms, run.holds);
      return true;
    }
    function* measure(): Generator<null, Costs, void> {
      const { level, terms, run } = proof.proof();
      return yield* costsOfNamed(level, terms, run.holds);
    }
    const begin = (wait: number) => {
      const results: NamedResult[] = [];
      cancel = inSlices(compare(), {
        wait,
        slice: 0,
        onSlice: (made) => results.push(...made),
        onDone(isPlayed) {
          if (!isPlayed) return;
          setState({ results, costs: null, isFresh: true });
          cancel = inSlices(measure(), { wait: CALM, slice: 0, onDone: (costs) => setState((now) => ({ ...now, costs })) });
        },
      });
    };
    const look = () => {
      const { file, level, terms, run } = proof.proof();
      const holds = run.holds.join();
      if (last !== null && last.holds === holds && last.maxTime === terms.maxTime && playsAlike(last, { file, level })) return;
      const wait = last === null ? 0 : REST;
      last = { file, level, holds, maxTime: terms.maxTime };
      cancel();
      setState(({ results }) => ({ results, costs: null, isFresh: false }));
      begin(wait);
    };
    look();
    const stop = proof.store.subscribe(look);
    return () => {
      stop();
      cancel();
    };
  }, [proof]);
  return state;
}

import { useEffect, useState } from 'react';
import { useLevel } from '../../core/context/index.ts';
import { nextTurn } from '../../core/figures/index.ts';
import { type PlayedFile, playsAlike } from '../../core/proof/index.ts';
import { type Costs, compareNamed, costsOfNamed, type NamedResult } from './named-results.ts';

/** ms without a change before a run is compared again */
const SETTLE = 200;
/** ms after the comparison before the costs are measured */
const CALM = 300;

export interface NamedResults {
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
    let timer: ReturnType<typeof setTimeout> | undefined;
    let last: (PlayedFile & { readonly holds: string; readonly maxTime: number }) | null = null;
    let abort = new AbortController();
    const measure = async () => {
      const { level, terms, run } = proof.proof();
      const { signal } = abort;
      const costs = await costsOfNamed(level, terms, run.holds, { now: () => performance.now(), pause: nextTurn, signal });
      if (costs !== null) setState((state) => ({ ...state, costs }));
    };
    const compare = () => {
      const { level, terms, run, limit } = proof.proof();
      if (limit !== null) return;
      const steps = compareNamed(level, terms, run.holds);
      const results: NamedResult[] = [];
      const step = () => {
        const next = steps.next();
        if (next.done === true) {
          setState({ results, costs: null, isFresh: true });
          timer = setTimeout(() => void measure(), CALM);
          return;
        }
        results.push(next.value);
        timer = setTimeout(step, 0);
      };
      step();
    };
    const look = () => {
      const { file, level, terms, run } = proof.proof();
      const holds = run.holds.join();
      if (last !== null && last.holds === holds && last.maxTime === terms.maxTime && playsAlike(last, { file, level })) return;
      const wait = last === null ? 0 : SETTLE;
      last = { file, level, holds, maxTime: terms.maxTime };
      clearTimeout(timer);
      abort.abort();
      abort = new AbortController();
      setState(({ results }) => ({ results, costs: null, isFresh: false }));
      timer = setTimeout(compare, wait);
    };
    look();
    const stop = proof.store.subscribe(look);
    return () => {
      stop();
      abort.abort();
      clearTimeout(timer);
    };
  }, [proof]);
  return state;
}

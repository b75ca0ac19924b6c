import type { Hold } from '../../schema/index.ts';
import { type Closest, type Effort, mergeSolutions, type Robustness, type Solution } from '../../solver/index.ts';
import type { Limits } from '../search-options.ts';
import type { LaneState } from './messages.ts';
import { LANES, rounds, type SolveSettings } from './settings.ts';
import { startThread } from './thread.ts';

/** What the lanes have found together. */
export interface Found {
  readonly effort: Effort;
  readonly closest: Closest | null;
  /** Best first, really different ones. */
  readonly solutions: readonly Solution[];
}

/** Threads that search together. */
export interface WorkerPool {
  /**
   * Searches until nothing can get better, or a limit is reached.
   * @param onRound called with what there is by then
   */
  search(limits: Limits, onRound: (found: Found) => void): Promise<Found>;
  /** How much each of these runs forgives. */
  measure(runs: readonly (readonly Hold[])[]): Promise<readonly Robustness[]>;
  /** Ends the threads. */
  close(): Promise<void>;
}

/**
 * Starts worker threads that share the lanes of a search.
 * @param jobs the most threads; what they find does not depend on it
 */
export function startWorkerPool(settings: SolveSettings, jobs: number): WorkerPool {
  const threads = Math.min(jobs, LANES);
  const stopped = new Int32Array(new SharedArrayBuffer(4));
  const workers = Array.from({ length: threads }, (_, thread) => {
    const own = Array.from({ length: LANES }, (_, lane) => lane).filter((lane) => lane % threads === thread);
    return startThread({ settings, lanes: own, stop: stopped.buffer as SharedArrayBuffer });
  });
  const isStopped = (): boolean => Atomics.load(stopped, 0) !== 0;
  const halt = (): void => {
    Atomics.store(stopped, 0, 1);
  };

  /** Every lane at so many ticks in all, or where it was stopped. */
  async function advance(to: number): Promise<LaneState[]> {
    const answers = await Promise.all(workers.map((worker) => worker.ask({ kind: 'advance', to }, 'advance')));
    return answers.flatMap((answer) => answer.lanes).sort((a, b) => a.lane - b.lane);
  }

  async function search({ budget, effort }: Limits, onRound: (found: Found) => void): Promise<Found> {
    // a thread takes a while to start, and runs that are known are looked at however short the budget
    let states = await advance(1);
    const clock = budget === null ? undefined : setTimeout(halt, 1000 * budget);
    try {
      for (const to of rounds(effort)) {
        states = await advance(to);
        onRound(together(states, settings.count));
        // the lanes meet after each round, so that who is done first doesn't depend on who had more threads
        if (isStopped() || states.some((state) => state.finished)) break;
      }
      return together(states, settings.count);
    } finally {
      clearTimeout(clock);
    }
  }

  return {
    search,
    async measure(runs) {
      const answers = runs.map((holds, i) => workers[i % threads].ask({ kind: 'measure', holds }, 'measure'));
      return (await Promise.all(answers)).map((answer) => answer.robustness);
    },
    async close() {
      await Promise.all(workers.map((worker) => worker.end()));
    },
  };
}

function together(states: readonly LaneState[], count: number): Found {
  const closest = states.flatMap((state) => state.closest ?? []);
  return {
    effort: {
      runs: states.reduce((sum, { effort }) => sum + effort.runs, 0),
      ticks: states.reduce((sum, { effort }) => sum + effort.ticks, 0),
    },
    closest: closest.reduce<Closest | null>((best, c) => (best === null || c.distance < best.distance ? c : best), null),
    solutions: mergeSolutions(
      states.map((state) => state.solutions),
      { count },
    ),
  };
}

import type { Hold } from '../../schema/index.ts';
import type { Robustness } from '../../solver/index.ts';
import { startThread, type Thread } from '../io/index.ts';
import type { Limits } from '../options/index.ts';
import { type Found, searchInRounds } from './rounds.ts';
import {
  type Answer,
  LANES,
  type LaneState,
  PROOF_LANE,
  type Request,
  type Round,
  type SolveSettings,
  type WorkerData,
} from './settings.ts';

/** Threads that share a search. */
export interface WorkerPool {
  /**
   * Searches until nothing can improve or a limit is reached.
   * @param onRound called after each round with the results so far
   */
  search(limits: Limits, onRound: (found: Found) => void): Promise<Found>;
  /** Measures the robustness of each of these runs. */
  measure(runs: readonly (readonly Hold[])[]): Promise<readonly Robustness[]>;
  /** Ends the threads. */
  close(): Promise<void>;
}

/**
 * Starts worker threads that share the lanes of a search.
 * @param jobs the largest number of threads; the result does not depend on it
 */
export async function startWorkerPool(settings: SolveSettings, jobs: number): Promise<WorkerPool> {
  const threads = Math.min(jobs, LANES);
  const stopped = new Int32Array(new SharedArrayBuffer(4));
  const starting = Array.from({ length: threads }, (_, thread) => {
    const own = [...Array(LANES).keys(), PROOF_LANE].filter((lane) => lane % threads === thread);
    const data: WorkerData = { settings, lanes: own, stop: stopped.buffer as SharedArrayBuffer };
    return startThread<Request, Answer>(new URL('./worker.js', import.meta.url), data);
  });
  const workers = await Promise.all(starting);
  const isStopped = (): boolean => Atomics.load(stopped, 0) !== 0;
  const halt = (): void => {
    Atomics.store(stopped, 0, 1);
  };

  /** Advances every lane to a total number of ticks, unless it is stopped before. */
  async function advance(round: Round): Promise<LaneState[]> {
    const answers = await Promise.all(workers.map((worker) => ask(worker, { kind: 'advance', round })));
    return answers.flatMap((answer) => answer.lanes).sort((a, b) => a.lane - b.lane);
  }

  async function search({ budget, effort }: Limits, onRound: (found: Found) => void): Promise<Found> {
    // before the clock starts: threads take a while to start, and known runs are evaluated even with a very short budget
    const states = await advance({ search: 1, proof: 0 });
    const clock = budget === null ? undefined : setTimeout(halt, 1000 * budget);
    try {
      return await searchInRounds(states, advance, { effort, count: settings.count, isStopped, onRound });
    } finally {
      clearTimeout(clock);
    }
  }

  return {
    search,
    async measure(runs) {
      const answers = runs.map((holds, i) => ask(workers[i % threads], { kind: 'measure', holds }));
      return (await Promise.all(answers)).map((answer) => answer.robustness);
    },
    async close() {
      await Promise.all(workers.map((worker) => worker.end()));
    },
  };
}

type AnswerTo<R extends Request> = Extract<Answer, { kind: R['kind'] }>;

/** @throws what went wrong in the thread */
async function ask<R extends Request>(worker: Thread<Request, Answer>, request: R): Promise<AnswerTo<R>> {
  const answer = await worker.ask(request);
  if (answer.kind === request.kind) return answer as AnswerTo<R>;
  throw new Error(answer.kind === 'failed' ? answer.why : `asked for ${request.kind}, a worker gave ${answer.kind}`);
}

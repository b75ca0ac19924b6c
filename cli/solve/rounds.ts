import type { Hold } from '../../schema/index.ts';
import {
  type Closest,
  type Effort,
  mergeSolutions,
  type Proof,
  proofShare,
  type Robustness,
  type Solution,
} from '../../solver/index.ts';
import { startThread, type Thread } from '../io/index.ts';
import type { Limits } from '../options/index.ts';
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

/** Ticks of a lane in the first round, and in the longest; rounds get longer at first. */
const FIRST_STEP = 20_000;
const LONGEST_STEP = 500_000;

/** The combined results of all lanes. */
export interface Found {
  readonly effort: Effort;
  readonly closest: Closest | null;
  /** Really different runs, best first. */
  readonly solutions: readonly Solution[];
  /** The proof that there is no run; null if there is none. */
  readonly impossible: Proof | null;
}

/** What a search in rounds needs of whoever has the lanes. */
interface Rounds {
  /** The limit of all lanes together, ticks; null: none. */
  readonly effort: number | null;
  /** The wanted number of really different runs. */
  readonly count: number;
  readonly isStopped: () => boolean;
  /** Called after each round with the results so far. */
  readonly onRound: (found: Found) => void;
}

/**
 * Searches until nothing can improve or a limit is reached. The lanes wait for each other after each round, so that the result does
 * not depend on the number of threads. As long as there is no run, the proof lane may do as much work as all others together;
 * what it does counts against the effort.
 * @param states the lanes once their known runs are evaluated
 * @param advance advances all lanes to a total number of ticks
 */
export async function searchInRounds(
  states: readonly LaneState[],
  advance: (round: Round) => readonly LaneState[] | Promise<readonly LaneState[]>,
  { effort, count, isStopped, onRound }: Rounds,
): Promise<Found> {
  let last = states;
  let step = FIRST_STEP;
  const round = { search: 0, proof: 0 };
  const left = (): number => (effort === null ? Number.POSITIVE_INFINITY : effort - round.search * LANES - proved(last));
  while (left() > 0) {
    round.search += Math.min(step, Math.ceil(left() / LANES));
    const hasNone = last.every(({ solutions }) => solutions.length === 0);
    if (hasNone) round.proof = Math.max(round.proof, proofShare(round.search * LANES, effort ?? Number.POSITIVE_INFINITY));
    last = await advance({ ...round });
    onRound(together(last, count));
    if (isStopped() || last.some(({ finished }) => finished)) break;
    step = Math.min(LONGEST_STEP, 2 * step);
  }
  return together(last, count);
}

/** The work of the proof lane so far, ticks. */
const proved = (states: readonly LaneState[]): number => states.find(({ lane }) => lane === PROOF_LANE)?.effort.ticks ?? 0;

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
    impossible: states.find(({ impossible }) => impossible !== null)?.impossible ?? null,
  };
}

/** The progress of a search in one line. */
export function progressText({ solutions, effort, closest }: Found, seconds: number): string {
  const so = `solving, ${seconds.toFixed(0)} s, ${(effort.ticks / 1e6).toFixed(1)} million ticks: `;
  const [best] = solutions;
  if (best === undefined) {
    return `${so}no run yet${closest === null ? '' : `, closest ${closest.distance.toFixed(1)} px`}; Ctrl-C ends`;
  }
  const presses = `${best.holds.length} ${best.holds.length === 1 ? 'press' : 'presses'}`;
  const p40 = best.p40 === null ? '' : `, success at 40 ms ${(100 * best.p40.p).toFixed(0)} %`;
  return `${so}${best.time.toFixed(2)} s, ${presses}${p40}; Ctrl-C drops it`;
}

/** Threads that share a search. */
interface WorkerPool {
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

import { parentPort, workerData } from 'node:worker_threads';
import { compile } from '../../engine/index.ts';
import { createSolver, measureRobustness, type Solver } from '../../solver/index.ts';
import type { Answer, LaneState, Request, WorkerData } from './messages.ts';

/** The number of executions for each probability. */
const SAMPLES = 1000;

/** The largest number of simulated runs to certify a run. */
const MOST_RUNS = 50_000;

/** Simulated ticks between two checks for a request to stop. */
const SLICE = 50_000;

interface Lane {
  readonly lane: number;
  readonly solver: Solver;
  /** The requested ticks; the solver may simulate slightly more. */
  asked: number;
}

const { settings, lanes, stop } = workerData as WorkerData;
const stopped = new Int32Array(stop);
const { level, accuracy, goal, objective, maxTicks, count, known, seed } = settings;
const scene = compile(level, accuracy);
const own = lanes.map((lane): Lane => {
  return { lane, solver: createSolver(scene, { goal, objective, maxTicks, count, known, seed, lane }), asked: 0 };
});

function advance(lane: Lane, to: number): void {
  // the first slice evaluates the known runs: it runs even if the search is stopped at once
  while (lane.asked < to && !lane.solver.finished && (lane.asked === 0 || Atomics.load(stopped, 0) === 0)) {
    const ticks = Math.min(SLICE, to - lane.asked);
    lane.solver.advance(ticks);
    lane.asked += ticks;
  }
}

const stateOf = ({ lane, solver }: Lane): LaneState => {
  const { effort, closest, solutions, finished } = solver;
  return { lane, effort: { ...effort }, closest, solutions: [...solutions], finished };
};

function answer(request: Request): Answer {
  switch (request.kind) {
    case 'advance':
      for (const lane of own) advance(lane, request.to);
      return { kind: 'advance', lanes: own.map(stateOf) };
    case 'measure':
      return {
        kind: 'measure',
        robustness: measureRobustness(scene, request.holds, goal, { samples: SAMPLES, seed, maxRuns: MOST_RUNS }),
      };
  }
}

parentPort?.on('message', (request: Request) => {
  try {
    parentPort?.postMessage(answer(request));
  } catch (error) {
    parentPort?.postMessage({ kind: 'failed', why: error instanceof Error ? (error.stack ?? error.message) : String(error) });
  }
});

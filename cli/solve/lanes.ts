import { compile, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { createSolver, measureRobustness, type Robustness, type Solver } from '../../solver/index.ts';
import type { LaneState } from './messages.ts';
import type { AskedRuns, SolveSettings } from './settings.ts';

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

/** Lanes of a search that one thread advances. */
export interface Lanes {
  /** Advances each lane to a total number of ticks, unless it is stopped before. */
  advance(to: number): LaneState[];
  measure(holds: readonly Hold[]): Robustness;
}

/** Measures how much a run forgives. */
export const measureRun = (scene: Scene, holds: readonly Hold[], { goal, seed }: AskedRuns): Robustness =>
  measureRobustness(scene, holds, goal, { samples: SAMPLES, seed, maxRuns: MOST_RUNS });

/** Opens lanes of a search in this thread. */
export function openLanes(settings: SolveSettings, numbers: readonly number[], isStopped: () => boolean): Lanes {
  const { level, accuracy, goal, objective, maxTicks, count, known, seed } = settings;
  const scene = compile(level, accuracy);
  const lanes = numbers.map((lane): Lane => {
    return { lane, solver: createSolver(scene, { goal, objective, maxTicks, count, known, seed, lane }), asked: 0 };
  });

  function advanceOne(lane: Lane, to: number): void {
    // the first slice evaluates the known runs: it runs even if the search is stopped at once
    while (lane.asked < to && !lane.solver.finished && (lane.asked === 0 || !isStopped())) {
      const ticks = Math.min(SLICE, to - lane.asked);
      lane.solver.advance(ticks);
      lane.asked += ticks;
    }
  }

  return {
    advance(to) {
      for (const lane of lanes) advanceOne(lane, to);
      return lanes.map(stateOf);
    },
    measure: (holds) => measureRun(scene, holds, settings),
  };
}

const stateOf = ({ lane, solver }: Lane): LaneState => {
  const { effort, closest, solutions, finished } = solver;
  return { lane, effort: { ...effort }, closest, solutions: [...solutions], finished };
};

import { compile, isAccuracyName, maxTicksOf, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { createAnytimeProof, createSolver, measureRobustness, type Robustness, type Solver } from '../../solver/index.ts';
import { type AskedRuns, type LaneState, PROOF_LANE, type Round, type SolveSettings } from './settings.ts';

/** The number of executions for each probability. */
const SAMPLES = 1000;

/** The largest number of simulated runs to certify a run. */
const MOST_RUNS = 50_000;

/** Simulated ticks between two checks for a request to stop. */
const SLICE = 50_000;

interface Lane {
  readonly isForProof: boolean;
  readonly state: () => LaneState;
  readonly advance: (ticks: number) => void;
  /** Whether nothing can improve any more. */
  readonly isOver: () => boolean;
  /** The requested ticks; slightly more may be simulated. */
  asked: number;
}

/** Lanes of a search that one thread advances. */
export interface Lanes {
  /** Advances each lane to a total number of ticks, unless it is stopped before. */
  advance(round: Round): LaneState[];
  measure(holds: readonly Hold[]): Robustness;
}

/** Measures how much a run forgives. */
export const measureRun = (scene: Scene, holds: readonly Hold[], { goal, seed }: AskedRuns): Robustness =>
  measureRobustness(scene, holds, goal, { samples: SAMPLES, seed, maxRuns: MOST_RUNS });

/** Opens lanes of a search in this thread. */
export function openLanes(settings: SolveSettings, numbers: readonly number[], isStopped: () => boolean): Lanes {
  const { level, terms, goal, objective, count, known, seed } = settings;
  const scene = compile(level, terms);
  const lanes = numbers.map((lane) =>
    lane === PROOF_LANE
      ? proofLane(settings, isStopped)
      : searchLane(
          lane,
          createSolver(scene, {
            goal,
            objective,
            count,
            known,
            seed,
            lane,
          }),
        ),
  );

  function advanceOne(lane: Lane, to: number): void {
    // the first slice evaluates the known runs: it runs even if the search is stopped at once
    while (lane.asked < to && !lane.isOver() && (lane.asked === 0 || !isStopped())) {
      const ticks = Math.min(SLICE, to - lane.asked);
      lane.advance(ticks);
      lane.asked += ticks;
    }
  }

  return {
    advance({ search, proof }) {
      for (const lane of lanes) advanceOne(lane, lane.isForProof ? proof : search);
      return lanes.map(({ state }) => state());
    },
    measure: (holds) => measureRun(scene, holds, settings),
  };
}

function searchLane(lane: number, solver: Solver): Lane {
  return {
    isForProof: false,
    asked: 0,
    advance: (ticks) => solver.advance(ticks),
    isOver: () => solver.finished,
    state: () => {
      const { effort, closest, solutions, finished } = solver;
      return { lane, effort: { ...effort }, closest, solutions: [...solutions], impossible: null, finished };
    },
  };
}

function proofLane({ level, terms, goal }: SolveSettings, isStopped: () => boolean): Lane {
  const { name } = terms.accuracy;
  const proving = isAccuracyName(name)
    ? createAnytimeProof(level, { accuracy: name, goal, maxTicks: maxTicksOf(terms), isStopped })
    : null;
  return {
    isForProof: true,
    asked: 0,
    advance: (ticks) => proving?.advance(ticks),
    isOver: () => proving?.finished !== false,
    state: () => ({
      lane: PROOF_LANE,
      effort: { runs: 0, ticks: proving?.ticks ?? 0 },
      closest: null,
      solutions: [],
      impossible: proving?.proof ?? null,
      finished: proving?.proof != null,
    }),
  };
}

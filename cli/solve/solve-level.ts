import { proveGoalImpossible } from '../../check/index.ts';
import { termsReport } from '../../check/words/index.ts';
import { compile, type Run, simulate } from '../../engine/index.ts';
import type { Hold, SolutionReport, SolveReport } from '../../schema/index.ts';
import { type Closest, type Effort, type Proof, type Robustness, type Solution, verifyRun } from '../../solver/index.ts';
import type { Limits } from '../options/index.ts';
import { robustnessJson } from '../report-parts/index.ts';
import { catchSignals, leaveSignals } from '../terminal/index.ts';
import { measureRun, openLanes } from './lanes.ts';
import { type Found, searchInRounds, startWorkerPool } from './rounds.ts';
import { LANES, PROOF_LANE, type SolveSettings } from './settings.ts';

/** A run that was found and replayed, with its robustness. */
export interface SolvedRun {
  readonly holds: readonly Hold[];
  readonly run: Run;
  readonly robustness: Robustness;
}

/** The result of solving a level. */
export interface Solved {
  /** Best first; empty if none was found. */
  readonly runs: readonly SolvedRun[];
  readonly effort: Effort;
  /** s of wall time */
  readonly seconds: number;
  /** null if a run was found or nothing was tried */
  readonly closest: Closest | null;
  /** The proof that there is no run; null if there is none. */
  readonly impossible: Proof | null;
}

interface SolveOptions {
  readonly limits: Limits;
  /** The largest number of threads; the result does not depend on it. */
  readonly jobs: number;
  readonly onRound: (found: Found) => void;
}

/** Tries to prove quickly that there is no run, then searches for one, or for a longer proof, in worker threads. */
export const solveLevel = (settings: SolveSettings, { limits, jobs, onRound }: SolveOptions): Promise<Solved> =>
  solveBy(settings, async () => {
    catchSignals();
    const pool = await startWorkerPool(settings, jobs);
    try {
      const found = await pool.search(limits, onRound);
      return { ...found, measured: await pool.measure(found.solutions.map(({ holds }) => holds)) };
    } finally {
      await pool.close();
      // replays may take long and block the loop: from here on a signal must end the process at once
      await leaveSignals();
    }
  });

const ALL_LANES = [...Array(LANES).keys(), PROOF_LANE];

/** The same in this thread, which it blocks; by effort, the result is the same. */
export const solveHere = (settings: SolveSettings, { budget, effort }: Limits): Promise<Solved> =>
  solveBy(settings, async () => {
    const end = budget === null ? Number.POSITIVE_INFINITY : performance.now() + 1000 * budget;
    const isStopped = (): boolean => performance.now() >= end;
    const lanes = openLanes(settings, ALL_LANES, isStopped);
    const found = await searchInRounds(lanes.advance({ search: 1, proof: 0 }), lanes.advance, {
      effort,
      count: settings.count,
      isStopped,
      onRound: () => {},
    });
    return { ...found, measured: found.solutions.map(({ holds }) => lanes.measure(holds)) };
  });

/**
 * Replays runs that were found before, and measures them.
 * @returns null if one of them does not reach the goal
 */
export function replayRuns(settings: SolveSettings, found: readonly (readonly Hold[])[]): readonly SolvedRun[] | null {
  const { level, terms, goal } = settings;
  const scene = compile(level, terms);
  if (found.some((holds) => verifyRun(scene, holds, goal) === null)) return null;
  return found.map((holds) => ({ holds, run: simulate(scene, holds), robustness: measureRun(scene, holds, settings) }));
}

async function solveBy(
  { level, terms, goal }: SolveSettings,
  search: () => Promise<Found & { readonly measured: readonly Robustness[] }>,
): Promise<Solved> {
  const start = performance.now();
  const since = (): number => (performance.now() - start) / 1000;
  const scene = compile(level, terms);
  const impossible = proveGoalImpossible(scene, goal);
  if (impossible !== null) return { runs: [], effort: { runs: 0, ticks: 0 }, seconds: since(), closest: null, impossible };
  const { solutions, effort, closest, impossible: proved, measured } = await search();
  const runs = solutions.map(({ holds }, i): SolvedRun => {
    // the report describes a replay from the start
    const run = simulate(scene, holds);
    if (run.outcome !== 'completed')
      throw new Error(`a run that was found does not complete the level: ${JSON.stringify(holds)}`);
    return { holds, run, robustness: measured[i] };
  });
  const isFound = runs.length > 0;
  return { runs, effort, seconds: since(), closest: isFound ? null : closest, impossible: isFound ? null : proved };
}

/** The results of `solve` as JSON has them. */
export function solveReport({ level, terms, seed, count }: SolveSettings, solved: Solved): SolveReport {
  const { runs, closest, impossible } = solved;
  const under = termsReport({ terms, level });
  const effort = { ...solved.effort, seconds: solved.seconds, seed };
  const toReport = (found: SolvedRun | undefined): SolutionReport => ({
    level: level.name,
    accuracy: terms.accuracy.name,
    terms: under,
    found: found !== undefined,
    holds: found === undefined ? null : holdsOf(found),
    outcome: found?.run.outcome ?? null,
    time: found?.run.time ?? null,
    tick: found?.run.tick ?? null,
    minerals: [...(found?.run.minerals ?? [])],
    effort,
    robustness: found === undefined ? null : robustnessJson(found.robustness),
    closest: closest === null ? null : { ...closest, holds: holdsOf(closest) },
    impossible:
      impossible === null
        ? null
        : { code: impossible.code, reason: impossible.reason, certificate: jsonOf(impossible.certificate) },
    hash: found?.run.hash ?? null,
  });
  const report: SolveReport = { version: 1, ...toReport(runs[0]) };
  if (count > 1) report.solutions = runs.map(toReport);
  return report;
}

const holdsOf = ({ holds }: Pick<Solution, 'holds'>): [number, number][] => holds.map(([press, release]) => [press, release]);

const jsonOf = (certificate: unknown) => certificate as NonNullable<SolutionReport['impossible']>['certificate'];

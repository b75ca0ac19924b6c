import { type Run, type Scene, simulate, TICK_RATE, type WorkBudget } from '../../engine/index.ts';
import type { Hold, Level, Problem, Verdict } from '../../schema/index.ts';
import { OUTDONE_WARNINGS } from '../../solver/index.ts';
import { type LostMineral, proveGoalImpossible, proveMineralsLost } from '../prove.ts';
import type { CheckSettings } from './checked-level.ts';
import { foundRun, noRun, noRunFound, provedImpossible } from './run-problems.ts';
import { searchLevel } from './search-level.ts';

/** A run and what came of it. */
export interface PlayedRun {
  readonly holds: readonly Hold[];
  readonly run: Run;
}

interface Judgement {
  readonly verdict: Verdict;
  readonly found: PlayedRun | null;
  readonly problems: readonly Omit<Problem, 'line' | 'column'>[];
  /** The code of a warning that says less than what was proved; null: there is none. */
  readonly outdone: string | null;
}

const ticksOf = ({ maxTime }: CheckSettings): number => Math.round(maxTime * TICK_RATE);

/** What can be said of a level that no scripted run completes: proofs are always tried, a search is made when asked for. */
/** @param played whether all runs were played to their end; @param budget what proofs may cost */
export function judgeWithoutRun(
  file: string,
  scene: Scene,
  settings: CheckSettings,
  played: boolean,
  budget: WorkBudget,
): Judgement {
  const { level } = scene;
  const { accuracy, search, maxTime } = settings;
  const hasRuns = level.runs.length > 0;
  const otherwise = hasRuns && played ? 'broken' : 'unproven';
  const proof = proveGoalImpossible(level, accuracy, { minerals: 'any' }, ticksOf(settings), budget);
  if (proof !== null) {
    const outdone = OUTDONE_WARNINGS[proof.code] ?? null;
    return { verdict: 'impossible', found: null, problems: [provedImpossible(file, proof)], outdone };
  }
  const unknown = { verdict: otherwise, found: null, outdone: null } as const;
  if (search === null) return { ...unknown, problems: hasRuns ? [] : [noRun(file)] };
  const searched = searchLevel(scene, search, settings);
  if (searched.found === null) return { ...unknown, problems: [noRunFound(searched)] };
  const { holds } = searched.found;
  const run = simulate(scene, holds, { maxTime });
  if (run.outcome !== 'completed') throw new Error(`a run that was found does not complete the level: ${JSON.stringify(holds)}`);
  return { verdict: 'completable', found: { holds, run }, problems: [foundRun(file, { holds }, hasRuns)], outdone: null };
}

/** Of more minerals than this it is not asked in one check whether they can be collected: each takes a moment. */
const MOST_MINERALS = 20;

/** Minerals of which it is proved that nobody collects them; only those that no run collects are asked about. */
export function mineralsLost(
  level: Level,
  scripted: readonly Run[],
  found: Run | null,
  settings: CheckSettings,
  budget: WorkBudget,
): LostMineral[] {
  if (!settings.proveMinerals) return [];
  const collected = new Set([...scripted, ...(found === null ? [] : [found])].flatMap((run) => run.minerals.map((m) => m.index)));
  const asked = [...level.minerals.keys()].filter((index) => !collected.has(index)).slice(0, MOST_MINERALS);
  return proveMineralsLost(level, settings.accuracy, asked, ticksOf(settings), budget);
}

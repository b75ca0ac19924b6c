import { findWarnings, type Run, type Scene, simulate, WorkBudget } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import { hangsOnAccuracy } from './accuracy-hangs.ts';
import { atOnce } from './brief.ts';
import { overrunOf, type RunFindings, scriptEnds } from './findings.ts';
import { withinWork } from './within-work.ts';

/**
 * Simulates all runs of a level.
 * @param scene the compiled level
 * @param budget limits the work of all runs together; a run that exceeds it is stopped
 * @param runs instead of those that the scene was compiled with
 * @returns the simulated runs in the order of the list; only the first has a recording
 */
export const playRuns = (scene: Scene, budget: WorkBudget, runs: Level['runs'] = scene.level.runs): Run[] =>
  runs.map(({ holds }, index) => simulate(scene, holds, { budget, record: index === 0 }));

/** How the runs were simulated, and what examining them may cost. */
export interface ExamineOptions {
  /** The level, compiled under the terms under which the runs were simulated. It may have other runs. */
  readonly scene: Scene;
  /** What is left of the budget of the runs. It limits the examination of what the runs come near to. */
  readonly budget: WorkBudget;
  /** A run that a search found; it is examined like the level's own runs. */
  readonly found?: Run | null;
}

/**
 * Examines how a level's runs ended and what looks wrong in the level. Yields between its parts.
 * @param level the level
 * @param runs its simulated runs, as {@link playRuns} returns them
 * @param options how the runs were simulated, and limits on the work
 * @returns the findings as plain data
 */
export function* examineInSteps(
  level: Level,
  runs: readonly Run[],
  { scene, budget, found = null }: ExamineOptions,
): Generator<null, RunFindings, void> {
  const areAllPlayed = runs.every(({ stopped }) => stopped === null);
  const stopped = areAllPlayed ? null : overrunOf(budget);
  // A separate budget, so that one part of a check does not starve another.
  const others = new WorkBudget(scene.terms.maxWork / 2);
  const hangs = areAllPlayed ? withinWork(others, () => hangsOnAccuracy(level, runs, scene, others)) : ([] as const);
  const all = found === null ? runs : [...runs, found];
  const collected = new Set<number>();
  for (const { minerals } of all) for (const { index } of minerals) collected.add(index);
  yield null;
  const warnings = withinWork(budget, () =>
    findWarnings(
      level,
      all.filter((run) => run.stopped === null),
      scene.terms,
    ),
  );
  return {
    accuracy: scene.accuracy.name,
    range: level.range,
    allow: level.allow ?? {},
    ends: scriptEnds(level.runs, runs),
    collected: [...collected],
    hangs: hangs ?? [],
    warnings: warnings ?? findWarnings(level, [], scene.terms),
    cuts: {
      runs: stopped,
      accuracies: hangs === null ? overrunOf(others) : null,
      nearness: areAllPlayed && budget.isUsedUp ? overrunOf(budget) : null,
    },
  };
}

/** {@link examineInSteps} at once. */
export const examineRuns = (level: Level, runs: readonly Run[], options: ExamineOptions): RunFindings =>
  atOnce(examineInSteps(level, runs, options));

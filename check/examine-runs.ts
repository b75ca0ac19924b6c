import { type Accuracy, findWarnings, type Run, type Scene, simulate, WorkBudget } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import { hangsOnAccuracy } from './accuracy-hangs.ts';
import { overrunOf, type RunFindings } from './findings.ts';
import { withinWork } from './within-work.ts';

/**
 * Plays a level's own runs, in their order.
 * @param budget what they may cost together; those it does not suffice for are stopped
 */
export const playRuns = (scene: Scene, maxTime: number, budget: WorkBudget): Run[] =>
  scene.level.runs.map(({ holds }, index) => simulate(scene, holds, { maxTime, budget, record: index === 0 }));

export interface ExamineOptions {
  /** The setting at which the runs were played. */
  readonly accuracy: Accuracy;
  /** s of simulated time after which a run is a timeout */
  readonly maxTime: number;
  /** pieces of motion that a check may cost, part for part */
  readonly maxWork: number;
  /** What is left of what the runs were played with: what they come near to is looked at with it. */
  readonly budget: WorkBudget;
  /** A run that a search found, which is looked at like the level's own. */
  readonly found?: Run | null;
}

/** What a level's own runs show, and what looks wrong in the level. @param runs of the level, simulated */
export function examineRuns(
  level: Level,
  runs: readonly Run[],
  { accuracy, maxTime, maxWork, budget, found = null }: ExamineOptions,
): RunFindings {
  const areAllPlayed = runs.every(({ stopped }) => stopped === null);
  const stopped = areAllPlayed ? null : overrunOf(budget);
  // a budget of its own, so that what one part of a check costs does not starve another
  const others = new WorkBudget(maxWork / 2);
  const hangs = areAllPlayed ? withinWork(others, () => hangsOnAccuracy(level, runs, accuracy, maxTime, others)) : ([] as const);
  const all = found === null ? runs : [...runs, found];
  const warnings = withinWork(budget, () =>
    findWarnings(
      level,
      all.filter((run) => run.stopped === null),
    ),
  );
  return {
    accuracy: accuracy.name,
    range: level.range,
    ends: runs.map(({ outcome, with: touched, time, tick, stopped: by }, i) => ({
      name: level.runs[i].name,
      outcome,
      with: touched,
      time,
      tick,
      isStopped: by !== null,
    })),
    collected: [...new Set(all.flatMap(({ minerals }) => minerals.map(({ index }) => index)))],
    hangs: hangs ?? [],
    warnings: warnings ?? findWarnings(level, []),
    cuts: {
      runs: stopped,
      accuracies: hangs === null ? overrunOf(others) : null,
      nearness: areAllPlayed && budget.isUsedUp ? overrunOf(budget) : null,
    },
  };
}

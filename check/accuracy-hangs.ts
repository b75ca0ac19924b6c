import {
  ACCURACIES,
  type Accuracy,
  atAccuracy,
  createSimulation,
  joinHolds,
  maxTicksOf,
  playScript,
  type Scene,
  TICK,
  type WorkBudget,
} from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import type { RunEnd } from './words/index.ts';

/** A run that completes the level at some accuracies but not at others. */
export interface AccuracyHang {
  /** Index in the level's list of runs, from 0. */
  readonly index: number;
  /** Name of the run. */
  readonly name: string;
  /** How the run ends at each accuracy, the requested one first. */
  readonly ends: readonly { readonly accuracy: string; readonly end: RunEnd }[];
}

/**
 * Finds the runs that complete the level at some accuracies but not at others. A run that fails in different ways is not
 * reported, because it proves nothing anyway. To save time, only the coarsest and the finest accuracy are simulated besides the
 * requested one; the others follow only where those disagree.
 * @param level the level
 * @param runs how the level's runs end at the requested accuracy, in the order of its list
 * @param scene the level, compiled at the requested accuracy
 * @param budget limits the work
 * @throws WorkLimitReached when the budget is spent
 */
export function hangsOnAccuracy(level: Level, runs: readonly RunEnd[], scene: Scene, budget: WorkBudget): AccuracyHang[] {
  if (runs.length === 0) return [];
  const maxTicks = maxTicksOf(scene.terms);
  const ends = new Map<string, readonly RunEnd[]>([[scene.accuracy.name, runs]]);
  const play = (accuracy: Accuracy): void => {
    if (!ends.has(accuracy.name)) ends.set(accuracy.name, playAll(level, atAccuracy(scene, accuracy), maxTicks, budget));
  };
  const completes = (list: readonly RunEnd[], index: number): boolean => list[index].outcome === 'completed';
  const agree = (index: number): boolean => [...ends.values()].every((list) => completes(list, index) === completes(runs, index));
  play(ACCURACIES.arcade);
  play(ACCURACIES.precise);
  if (runs.every((_, index) => agree(index))) return [];
  for (const accuracy of Object.values<Accuracy>(ACCURACIES)) play(accuracy);
  return level.runs.flatMap(({ name }, index) =>
    agree(index) ? [] : [{ index, name, ends: [...ends].map(([accuracy, list]) => ({ accuracy, end: endOf(list[index]) })) }],
  );
}

/** Keeps only how a run ended, because the full record is too large to send from a worker. */
const endOf = ({ outcome, with: touched, time, tick }: RunEnd): RunEnd => ({ outcome, with: touched, time, tick });

function playAll(level: Level, scene: Scene, maxTicks: number, budget: WorkBudget): RunEnd[] {
  const simulation = createSimulation(scene, budget);
  return level.runs.map(({ holds }, index) => {
    if (index > 0) simulation.reset();
    playScript(simulation, joinHolds(holds), maxTicks);
    return simulation.ending ?? { outcome: 'timeout', with: null, time: maxTicks * TICK, tick: maxTicks };
  });
}

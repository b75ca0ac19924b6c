import {
  ACCURACIES,
  type Accuracy,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  TICK,
  TICK_RATE,
  type WorkBudget,
} from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import type { RunEnd } from './words/index.ts';

/** A run that completes the level at some accuracies and not at others. */
export interface AccuracyHang {
  /** Of the run in the level's list. */
  readonly index: number;
  readonly name: string;
  /** How it ends at each accuracy: the one asked for first. */
  readonly ends: readonly { readonly accuracy: string; readonly end: RunEnd }[];
}

/**
 * Runs that complete the level at some accuracies and not at others. Two that fail in different ways are no
 * news: such a run proves nothing anyway. Beside the accuracy asked for the coarsest and the finest are played, and the
 * others only where those don't agree: a thousand levels have to be checked while somebody waits.
 * @param runs how the level's end at the accuracy asked for; at the others they are only played, nothing recorded
 * @param budget what playing them may cost
 * @throws WorkLimitReached
 */
export function hangsOnAccuracy(
  level: Level,
  runs: readonly RunEnd[],
  asked: Accuracy,
  maxTime: number,
  budget: WorkBudget,
): AccuracyHang[] {
  if (runs.length === 0) return [];
  const maxTicks = Math.round(maxTime * TICK_RATE);
  const ends = new Map<string, readonly RunEnd[]>([[asked.name, runs]]);
  const play = (accuracy: Accuracy): void => {
    if (!ends.has(accuracy.name)) ends.set(accuracy.name, playAll(level, accuracy, maxTicks, budget));
  };
  const agree = (index: number): boolean => {
    const [first, ...rest] = [...ends.values()].map((list) => list[index].outcome === 'completed');
    return rest.every((completes) => completes === first);
  };
  play(ACCURACIES.arcade);
  play(ACCURACIES.precise);
  if (runs.every((_, index) => agree(index))) return [];
  for (const accuracy of Object.values<Accuracy>(ACCURACIES)) play(accuracy);
  return level.runs.flatMap(({ name }, index) =>
    agree(index) ? [] : [{ index, name, ends: [...ends].map(([accuracy, list]) => ({ accuracy, end: endOf(list[index]) })) }],
  );
}

/** Nothing but how it ended: a run has much more, which no worker could send. */
const endOf = ({ outcome, with: touched, time, tick }: RunEnd): RunEnd => ({ outcome, with: touched, time, tick });

function playAll(level: Level, accuracy: Accuracy, maxTicks: number, budget: WorkBudget): RunEnd[] {
  const simulation = createSimulation(compile(level, accuracy), budget);
  return level.runs.map(({ holds }) => {
    simulation.reset();
    playScript(simulation, joinHolds(holds), maxTicks);
    return simulation.ending ?? { outcome: 'timeout', with: null, time: maxTicks * TICK, tick: maxTicks };
  });
}

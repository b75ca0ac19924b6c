import {
  ACCURACIES,
  type Accuracy,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  type Run,
  TICK,
  TICK_RATE,
  type WorkBudget,
} from '../../engine/index.ts';
import type { Level, Problem } from '../../schema/index.ts';
import { outcomeInWords } from '../outcome.ts';
import { shellPath } from '../shown-path.ts';

type Ended = Pick<Run, 'outcome' | 'with' | 'time' | 'tick'>;

/**
 * Warnings of runs that complete the level at some accuracies and not at others. Two that fail in different ways are no
 * news: such a run proves nothing anyway. Beside the accuracy asked for the coarsest and the finest are played, and the
 * others only where those don't agree: a thousand levels have to be checked while somebody waits.
 * @param runs the level's, simulated at the accuracy asked for; the others are only played, nothing recorded
 * @param budget what playing them may cost
 * @throws WorkLimitReached
 */
export function hangsOnAccuracy(
  file: string,
  level: Level,
  runs: readonly Run[],
  asked: Accuracy,
  maxTime: number,
  budget: WorkBudget,
): Omit<Problem, 'line' | 'column'>[] {
  if (runs.length === 0) return [];
  const maxTicks = Math.round(maxTime * TICK_RATE);
  const outcomes = new Map<string, readonly Ended[]>([[asked.name, runs]]);
  const play = (accuracy: Accuracy): void => {
    if (!outcomes.has(accuracy.name)) outcomes.set(accuracy.name, playAll(level, accuracy, maxTicks, budget));
  };
  const agree = (index: number): boolean => {
    const [first, ...rest] = [...outcomes.values()].map((ended) => ended[index].outcome === 'completed');
    return rest.every((completes) => completes === first);
  };
  play(ACCURACIES.arcade);
  play(ACCURACIES.precise);
  if (runs.every((_, index) => agree(index))) return [];
  for (const accuracy of Object.values<Accuracy>(ACCURACIES)) play(accuracy);
  return runs.flatMap((_, index) => {
    if (agree(index)) return [];
    const all = [...outcomes].map(([name, ended]) => ({ name, ended: ended[index] }));
    const good = all.filter(({ ended }) => ended.outcome === 'completed').map(({ name }) => name);
    const bad = all
      .filter(({ ended }) => ended.outcome !== 'completed')
      .map(({ name, ended }) => `${name} (${outcomeInWords(ended, level)})`);
    const name = JSON.stringify(level.runs[index].name);
    return [
      {
        code: 'verdict-hangs-on-accuracy',
        severity: 'warning',
        message: `run ${name} completes the level under ${good.join(', ')}, but not under ${bad.join(', ')}`,
        hint: `it hangs by a hair: give it more room, or change the run; see gq accuracy ${shellPath(file)} --run ${name}`,
        pointer: `/runs/${index}`,
      },
    ];
  });
}

function playAll(level: Level, accuracy: Accuracy, maxTicks: number, budget: WorkBudget): Ended[] {
  const simulation = createSimulation(compile(level, accuracy), budget);
  return level.runs.map(({ holds }) => {
    simulation.reset();
    playScript(simulation, joinHolds(holds), maxTicks);
    return simulation.ending ?? { outcome: 'timeout', with: null, time: maxTicks * TICK, tick: maxTicks };
  });
}

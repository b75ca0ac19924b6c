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
} from '../../engine/index.ts';
import type { Level, Problem } from '../../schema/index.ts';
import { outcomeInWords } from '../outcome.ts';

type Ended = Pick<Run, 'outcome' | 'with' | 'time' | 'tick'>;

/**
 * Warnings of runs that complete the level at some accuracies and not at others. Two that fail in different ways are no
 * news: such a run proves nothing anyway.
 * @param runs the level's, simulated at the accuracy asked for; the others are only played, nothing recorded
 */
export function hangsOnAccuracy(
  file: string,
  level: Level,
  runs: readonly Run[],
  asked: Accuracy,
  maxTime: number,
): Omit<Problem, 'line' | 'column'>[] {
  if (runs.length === 0) return [];
  const others = Object.values<Accuracy>(ACCURACIES).filter((accuracy) => accuracy.name !== asked.name);
  const outcomes = others.map((accuracy) => playAll(level, accuracy, Math.round(maxTime * TICK_RATE)));
  return runs.flatMap((run, index) => {
    const completes = (ended: Ended): boolean => ended.outcome === 'completed';
    if (outcomes.every((ended) => completes(ended[index]) === completes(run))) return [];
    const all = [
      { name: asked.name, ended: run as Ended },
      ...others.map(({ name }, i) => ({ name, ended: outcomes[i][index] })),
    ];
    const good = all.filter(({ ended }) => completes(ended)).map(({ name }) => name);
    const bad = all
      .filter(({ ended }) => !completes(ended))
      .map(({ name, ended }) => `${name} (${outcomeInWords(ended, level)})`);
    const name = JSON.stringify(level.runs[index].name);
    const path = /^[\w./\\:-]+$/.test(file) ? file : JSON.stringify(file);
    return [
      {
        code: 'verdict-hangs-on-accuracy',
        severity: 'warning',
        message: `run ${name} completes the level under ${good.join(', ')}, but not under ${bad.join(', ')}`,
        hint: `it hangs by a hair: give it more room, or change the run; see gq accuracy ${path} --run ${name}`,
        pointer: `/runs/${index}`,
      },
    ];
  });
}

function playAll(level: Level, accuracy: Accuracy, maxTicks: number): Ended[] {
  const simulation = createSimulation(compile(level, accuracy));
  return level.runs.map(({ holds }) => {
    simulation.reset();
    playScript(simulation, joinHolds(holds), maxTicks);
    return simulation.ending ?? { outcome: 'timeout', with: null, time: maxTicks * TICK, tick: maxTicks };
  });
}

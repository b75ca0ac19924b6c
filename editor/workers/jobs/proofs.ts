import { mineralsToProve, playRuns, proveGoalImpossible, proveMineralsLost } from '../../../check/index.ts';
import { ACCURACIES, compile, DEFAULT_MAX_TIME, DEFAULT_MAX_WORK, TICK_RATE, WorkBudget } from '../../../engine/index.ts';
import type { Played } from '../protocol.ts';
import type { Start } from '../work.ts';

const MAX_TICKS = Math.round(DEFAULT_MAX_TIME * TICK_RATE);

/** Proves what can't be reached, with as much work as `gq check` allows. Every result is confirmed by the separate checker. */
export const proofs: Start<'proofs'> = function* ({ level, accuracy, collected }) {
  const budget = new WorkBudget(DEFAULT_MAX_WORK / 2);
  const setting = ACCURACIES[accuracy];
  const impossible = proveGoalImpossible(level, setting, { minerals: 'any' }, MAX_TICKS, budget);
  yield { impossible, minerals: [] };
  const asked = mineralsToProve(level, collected ?? collectedIn({ level, accuracy }));
  return { impossible, minerals: proveMineralsLost(level, setting, asked, MAX_TICKS, budget) };
};

/** Indices of the minerals that some run of the level collects. */
const collectedIn = ({ level, accuracy }: Played): number[] =>
  playRuns(compile(level, accuracy), DEFAULT_MAX_TIME, new WorkBudget()).flatMap(({ minerals }) =>
    minerals.map(({ index }) => index),
  );

import { mineralsToProve, playRuns, proveGoalImpossible, proveMineralsLost } from '../../../check/index.ts';
import { ACCURACIES, compile, DEFAULT_MAX_TICKS, DEFAULT_MAX_TIME, DEFAULT_MAX_WORK, WorkBudget } from '../../../engine/index.ts';
import { createAnytimeProof } from '../../../solver/index.ts';
import type { Played } from '../protocol.ts';
import type { Start } from '../work.ts';

/** Ticks between two looks at the clock. */
const SLICE = 50_000;

/**
 * Proves what can't be reached, with as much work as `gq check` allows, and then for `finer` ms with ever finer sets that the
 * black hole can't be. Every result is confirmed by the separate checker.
 */
export const proofs: Start<'proofs'> = function* ({ level, accuracy, collected, finer = 0 }, now) {
  const end = now() + finer;
  const budget = new WorkBudget(DEFAULT_MAX_WORK / 2);
  const setting = ACCURACIES[accuracy];
  const impossible = proveGoalImpossible(level, setting, { minerals: 'any' }, DEFAULT_MAX_TICKS, budget);
  yield { impossible, minerals: [] };
  const asked = mineralsToProve(level, collected ?? collectedIn({ level, accuracy }));
  const minerals = proveMineralsLost(level, setting, asked, DEFAULT_MAX_TICKS, budget);
  if (impossible !== null) return { impossible, minerals };
  yield { impossible, minerals };
  const isStopped = () => now() >= end;
  const proving = createAnytimeProof(level, { accuracy, maxTicks: DEFAULT_MAX_TICKS, isStopped });
  while (!proving.finished && !isStopped()) {
    proving.advance(SLICE);
    yield null;
  }
  return { impossible: proving.proof, minerals };
};

/** Indices of the minerals that some run of the level collects. */
const collectedIn = ({ level, accuracy }: Played): number[] =>
  playRuns(compile(level, accuracy), DEFAULT_MAX_TIME, new WorkBudget()).flatMap(({ minerals }) =>
    minerals.map(({ index }) => index),
  );

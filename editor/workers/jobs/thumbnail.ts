import { proveGoalImpossible, verdictOf, withinWork } from '../../../check/index.ts';
import { effectsToMeet } from '../../../check/pack/index.ts';
import { countMinerals } from '../../../check/words/index.ts';
import {
  ACCURACIES,
  compile,
  DEFAULT_MAX_TICKS,
  DEFAULT_MAX_WORK,
  type Run,
  simulate,
  WorkBudget,
} from '../../../engine/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import { readLevel } from '../../../schema/index.ts';
import type { Start } from '../work.ts';

/** Draws a small picture of a level file, with a run that completes it if there is one, and gives the verdict of `gq check`. */
export const thumbnail: Start<'thumbnail'> = function* ({ text, rules, accuracy, width, theme }) {
  const reading = readLevel(text, { rules });
  if (!reading.ok) return { svg: '', verdict: 'invalid', minerals: 0, facts: null };
  const { level, document } = reading;
  const isUndecided = (document.file.conflicts ?? []).length > 0;
  const scene = compile(level, accuracy);
  const budget = new WorkBudget(DEFAULT_MAX_WORK);
  const runs: Run[] = [];
  for (const { holds } of level.runs) {
    if (runs.length > 0) yield null;
    runs.push(simulate(scene, holds, { budget }));
    if (runs.at(-1)?.outcome === 'completed') break;
  }
  const completing = runs.find(({ outcome }) => outcome === 'completed');
  if (completing === undefined) yield null;
  const proofs = new WorkBudget(DEFAULT_MAX_WORK / 2);
  const isImpossible =
    completing === undefined &&
    proveGoalImpossible(level, ACCURACIES[accuracy], { minerals: 'any' }, DEFAULT_MAX_TICKS, proofs) !== null;
  const played = verdictOf({
    isCompleted: completing !== undefined,
    isImpossible,
    runs: level.runs.length,
    areAllPlayed: runs.every(({ stopped }) => stopped === null),
  });
  // a merge has left two candidates for something: neither is judged
  const verdict = isUndecided ? 'invalid' : played;
  const shown = completing ?? runs[0];
  const looks = { width, theme, words: false };
  // the path of a run that cost too much is not drawn
  const svg =
    shown === undefined || shown.stopped !== null ? null : withinWork(budget, () => renderSvg(level, { run: shown, ...looks }));
  const minerals = shown === undefined ? 0 : countMinerals(shown);
  const facts = {
    effects: effectsToMeet(level),
    seconds: completing?.time ?? null,
    minerals,
    mineralCount: level.minerals.length,
  };
  return { svg: svg ?? renderSvg(level, looks), verdict, minerals, facts };
};

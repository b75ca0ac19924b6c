import { briefInSteps, withinWork } from '../../../check/index.ts';
import { effectsToMeet } from '../../../check/pack/index.ts';
import { countMinerals } from '../../../check/words/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import { readLevel } from '../../../schema/index.ts';
import type { Start } from '../work.ts';

/** Draws a small picture of a level file, with a run that completes it if there is one, and gives the verdict of `gq check`. */
export const thumbnail: Start<'thumbnail'> = function* ({ text, terms, width, theme }) {
  const reading = readLevel(text, { rules: terms.rules });
  if (!reading.ok) return { svg: '', verdict: 'invalid', minerals: 0, facts: null };
  const { level, document } = reading;
  const isUndecided = (document.file.conflicts ?? []).length > 0;
  const { verdict, run, budget } = yield* briefInSteps(level, terms);
  const looks = { width, theme, words: false };
  // the path of a run that cost too much is not drawn
  const svg = run === null ? null : withinWork(budget, () => renderSvg(level, { run, ...looks }));
  const minerals = run === null ? 0 : countMinerals(run);
  const facts = {
    effects: effectsToMeet(level),
    seconds: run?.outcome === 'completed' ? run.time : null,
    minerals,
    mineralCount: level.minerals.length,
  };
  // a merge has left two candidates for something: neither is judged
  return { svg: svg ?? renderSvg(level, looks), verdict: isUndecided ? 'invalid' : verdict, minerals, facts };
};

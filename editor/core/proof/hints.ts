import type { Hints } from '../../../check/index.ts';

/** Hints of problems on the page. */
export const PAGE_HINTS: Hints = {
  firstRun: 'play the level and keep an attempt as a run, or let the solver find a run',
  // both are visible: the run on the canvas, the others a click away
  seeRun: () => '',
  seeAccuracies: () => '; the accuracy panel shows the result at each setting',
  moreWork: ', aliens above all',
  seeLost: '',
  seeProof: ': move the objects that the reason names',
};

import type { Hints } from '../../check/index.ts';

/** What to do about a problem of a level on the page. */
export const PAGE_HINTS: Hints = {
  first: 1,
  firstRun: 'play it and make the attempt the proof, or let the solver look for a run',
  // both are in sight: the run on the canvas, the others a click away
  seeRun: () => '',
  seeAccuracies: () => '; the accuracy panel has what each setting makes of it',
  moreWork: ', aliens above all',
  seeProof: ': move what the reason names',
};

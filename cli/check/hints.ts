import type { Hints } from '../../check/index.ts';
import { byHolds } from '../report-parts/index.ts';

/** Hints for the command line about the problems of a level file. @param path the file, quoted for a shell */
export function commandHints(path: string): Hints {
  return {
    firstRun: `find one with gq solve ${path} --write, or add "runs": [{ "name": "solution", "holds": [[press, release], ...] }], in ticks of 1/60 s`,
    seeRun: (name) => `; to see how it ends: gq simulate ${path} --run ${JSON.stringify(name)}`,
    seeAccuracies: (name) => `; to compare all accuracies: gq accuracy ${path} --run ${JSON.stringify(name)}`,
    moreWork: ', or allow more work with --max-work; gq explain work-limit says more',
    seeLost: `; to see where: gq render ${path} --softlocks -o lost.svg`,
    seeProof: `; to see why: gq render ${path} --proof -o proof.svg`,
    search: {
      keepFound: `: gq solve ${path} --write`,
      nothingFound: 'draw that run with gq render --holds, make the level easier, or search longer with --budget or gq solve',
      nearestRun: byHolds,
      tightRun:
        'give her more room where timing is tight (gq difficulty --run NAME shows the slack of each press and release), or find a run that forgives more with gq solve',
    },
  };
}

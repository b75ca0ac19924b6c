import type { Hints } from '../../check/index.ts';
import { byHolds } from '../report-parts/index.ts';
import { shellPath } from '../shown-path.ts';

/** What to do about a problem of a level file on the command line. */
export function commandHints(file: string): Hints {
  const path = shellPath(file);
  return {
    firstRun: `let one be found: gq solve ${path} --write; or add "runs": [{ "name": "solution", "holds": [[press, release], ...] }], in ticks of 1/60 s`,
    seeRun: (name) => `; see gq simulate ${path} --run ${JSON.stringify(name)}`,
    seeAccuracies: (name) => `; see gq accuracy ${path} --run ${JSON.stringify(name)}`,
    moreWork: ', or allow more work with --max-work; see gq explain work-limit',
    seeProof: `: gq render ${path} --proof -o proof.svg draws why`,
    search: {
      keepFound: `: gq solve ${path} --write`,
      nothingFound: 'look at the nearest with gq render --holds, make the level easier, or search longer: --budget, gq solve',
      nearestRun: byHolds,
      tightRun:
        'give her more room where it is tight (gq difficulty shows each edge), or look for a run that forgives more: gq solve',
    },
  };
}

import { holdText } from './hold-text.ts';
import type { Rule } from './warning.ts';

/** Holds that are not in order of time, so that the list does not read as it is played. */
export const holdsUnsorted: Rule = {
  explanation: {
    code: 'holds-unsorted',
    severity: 'warning',
    title: 'the holds of a run are not in order of time',
    why: 'Holds are played in order of time, wherever they stand in the list. A list in another order misleads people who read it or compare two versions.',
    fix: 'Sort the holds by their first number.',
  },
  *find({ level }) {
    for (const [r, { name, holds }] of level.runs.entries()) {
      const i = holds.findIndex(([press], k) => k > 0 && press < holds[k - 1][0]);
      if (i < 0) continue;
      yield {
        message: `run ${JSON.stringify(name)}, hold ${i + 1}: ${holdText(holds[i])} comes after ${holdText(holds[i - 1])}, which presses later`,
        hint: 'sort the holds by their first number',
        pointer: `/runs/${r}/holds/${i}`,
      };
    }
  },
};

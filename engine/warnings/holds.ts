import type { Hold } from '../../schema/basics/index.ts';
import type { Rule } from './warning.ts';

/** Holds that overlap: the release between them never happens. */
export const holdsOverlap: Rule = {
  explanation: {
    code: 'holds-overlap',
    severity: 'warning',
    title: 'holds of a run overlap or touch',
    why: 'The gun has one button: while one hold lasts, another cannot begin. Holds that overlap or touch are played as one, so a release and a press that the run lists never happen.',
    fix: 'Join them into one hold, or begin the second at least one tick after the first ends.',
  },
  *find({ level }) {
    for (const [r, { name, holds }] of level.runs.entries()) {
      const order = [...holds.keys()].sort((a, b) => holds[a][0] - holds[b][0]);
      let last: number | null = null;
      for (const i of order) {
        const [press, release] = holds[i];
        if (release <= press) continue;
        if (last !== null && press <= holds[last][1]) {
          const end = holds[last][1];
          const how = press === end ? `touch at tick ${end}` : `overlap by ${Math.min(end, release) - press} ticks`;
          yield {
            message: `run ${JSON.stringify(name)}, holds ${last + 1} and ${i + 1}: ${holdText(holds[last])} and ${holdText(holds[i])} ${how} and are played as one`,
            hint: `write ${holdText([holds[last][0], Math.max(end, release)])} instead of the two, or press after tick ${end}`,
            pointer: `/runs/${r}/holds/${i}`,
          };
        }
        if (last === null || release > holds[last][1]) last = i;
      }
    }
  },
};

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

/** A hold as it stands in a file. */
const holdText = ([press, release]: Hold): string => `[${press}, ${release}]`;

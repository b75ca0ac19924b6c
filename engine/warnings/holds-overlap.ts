import { holdText } from './hold-text.ts';
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

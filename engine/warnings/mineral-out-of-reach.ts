import { objectName } from '../../schema/basics/index.ts';
import { outOfReach, RULE_OF_REACH } from './black-hole-out-of-reach.ts';
import type { Rule } from './warning.ts';

/** A mineral too far from every asteroid to be collected. */
export const mineralOutOfReach: Rule = {
  explanation: {
    code: 'mineral-out-of-reach',
    severity: 'warning',
    title: 'a mineral is out of reach of every asteroid',
    why: `${RULE_OF_REACH} So nobody can collect this mineral.`,
    fix: 'Move the mineral and an asteroid nearer to each other, or raise the range.',
  },
  *find(subject) {
    for (const [i, mineral] of subject.level.minerals.entries()) {
      yield* outOfReach(subject, objectName('mineral', i), mineral, `/minerals/${i}`);
    }
  },
};

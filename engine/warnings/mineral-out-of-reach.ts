import { objectName } from '../../schema/index.ts';
import { outOfReach, RULE_OF_REACH } from './out-of-reach.ts';
import type { Rule } from './warning.ts';

/** A mineral too far from every asteroid to be collected. */
export const mineralOutOfReach: Rule = {
  explanation: {
    code: 'mineral-out-of-reach',
    severity: 'warning',
    title: 'a mineral is out of reach of every asteroid',
    why: `${RULE_OF_REACH} So nobody can collect this mineral.`,
    fix: 'Put the mineral nearer to an asteroid, an asteroid nearer to the mineral, or raise the range.',
  },
  *find(subject) {
    for (const [i, mineral] of subject.level.minerals.entries()) {
      yield* outOfReach(subject, objectName('mineral', i), mineral, `/minerals/${i}`);
    }
  },
};

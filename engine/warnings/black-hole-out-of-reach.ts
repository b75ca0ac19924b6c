import { outOfReach, RULE_OF_REACH } from './out-of-reach.ts';
import type { Rule } from './warning.ts';

/** The black hole is too far from every asteroid, so the level cannot be completed. */
export const blackHoleOutOfReach: Rule = {
  explanation: {
    code: 'black-hole-out-of-reach',
    severity: 'warning',
    title: 'the black hole is out of reach of every asteroid',
    why: `${RULE_OF_REACH} So nobody can touch this black hole, and the level cannot be completed.`,
    fix: 'Put an asteroid nearer to the black hole, put one into the gap before it, or raise the range.',
  },
  find: (subject) => outOfReach(subject, 'the black hole', subject.level.blackHole, '/blackHole'),
};

import { covers, distance, px } from './bodies.ts';
import { outOfReach, RULE_OF_REACH } from './reach.ts';
import type { Rule } from './warning.ts';

/** The black hole lies inside a hazard, so touching it means touching the hazard. */
export const blackHoleCovered: Rule = {
  explanation: {
    code: 'black-hole-covered',
    severity: 'warning',
    title: 'a hazard covers the black hole',
    why: 'The whole disc of the black hole lies inside a nova, a hot asteroid or an alien. She cannot touch the black hole without touching the hazard, and when she touches both at the same instant the hazard wins. An alien can be lured away, and so can a hot asteroid in a level with recoil; a nova stays where it is.',
    fix: 'Move the hazard until she can reach the black hole from the intended side.',
  },
  *find({ level, bodies }) {
    for (const body of bodies) {
      if (!body.isHazard || !covers(body, level.blackHole)) continue;
      const moves = body.staysPut ? '' : ', at least until the hazard moves';
      yield {
        message:
          `${body.name} covers the black hole: the centres are ${px(distance(body, level.blackHole))} apart, ` +
          `the radii ${px(body.radius)} and ${px(level.blackHole.radius)}${moves}`,
        hint: `move ${body.name} away from the black hole, or make it smaller`,
        pointer: '/blackHole',
      };
    }
  },
};

/** The black hole is too far from every asteroid, so the level cannot be completed. */
export const blackHoleOutOfReach: Rule = {
  explanation: {
    code: 'black-hole-out-of-reach',
    severity: 'warning',
    title: 'the black hole is out of reach of every asteroid',
    why: `${RULE_OF_REACH} So nobody can touch this black hole, and the level cannot be completed.`,
    fix: 'Put an asteroid nearer to the black hole, put one into the gap before it, or raise the range.',
  },
  *find({ level, reach }) {
    const words = outOfReach(level, reach, 'the black hole', level.blackHole);
    if (words !== null) yield { ...words, pointer: '/blackHole' };
  },
};

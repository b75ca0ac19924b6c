import { covers, distance, px } from './bodies.ts';
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

import { isHazard, nameOf, staysPut } from './bodies.ts';
import { covers, distance, px } from './geometry.ts';
import type { Rule } from './warning.ts';

/** The black hole lies inside a hazard, so touching it means touching the hazard. */
export const blackHoleCovered: Rule = {
  explanation: {
    code: 'black-hole-covered',
    severity: 'warning',
    title: 'something deadly covers the black hole',
    why: 'The whole disc of the black hole lies inside a nova, a hot asteroid or an alien: who touches the black hole touches that too, and when both fall on the same instant the hazard wins. An alien, and with recoil a hot asteroid, can be drawn away; a nova stays.',
    fix: 'Move the hazard until the side of the black hole that she should come from is free.',
  },
  *find({ level, bodies }) {
    for (const body of bodies) {
      if (!isHazard(body) || !covers(body, level.blackHole)) continue;
      const moves = staysPut(body, level.recoil) ? '' : ', at least until it moves';
      yield {
        message:
          `${nameOf(body)} covers the black hole: centres ${px(distance(body, level.blackHole))} apart, ` +
          `radius ${px(body.radius)} against ${px(level.blackHole.radius)}${moves}`,
        hint: `move ${nameOf(body)} away from the black hole, or make it smaller`,
        pointer: '/blackHole',
      };
    }
  },
};

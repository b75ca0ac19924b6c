import { objectName } from '../../schema/basics/index.ts';
import { covers, distance, overlapsBetween, px } from './bodies.ts';
import { outOfReach, RULE_OF_REACH } from './reach.ts';
import type { Rule } from './warning.ts';

/** A mineral inside a hazard: collecting it ends the run. */
export const mineralCovered: Rule = {
  explanation: {
    code: 'mineral-covered',
    severity: 'warning',
    title: 'a mineral lies inside a hazard',
    why: 'The whole disc of the mineral lies inside a nova, or inside a hot asteroid that stays where it is. She cannot touch the mineral without touching the hazard, which ends the run.',
    fix: 'Move the mineral out until at least part of it can be touched from outside.',
  },
  *find({ level, bodies }) {
    const hazards = bodies.filter(({ isHazard, staysPut }) => isHazard && staysPut);
    if (hazards.length === 0) return;
    const minerals = level.minerals.map(({ x, y, radius }, index) => ({ x, y, radius, index }));
    const reported = new Set<number>();
    for (const [mineral, hazard] of overlapsBetween(minerals, hazards)) {
      if (reported.has(mineral.index) || !covers(hazard, mineral)) continue;
      reported.add(mineral.index);
      const name = objectName('mineral', mineral.index);
      const apart = distance(hazard, mineral);
      yield {
        message: `${name} lies inside ${hazard.name}: the centres are ${px(apart)} apart, the radii ${px(mineral.radius)} and ${px(hazard.radius)}`,
        hint: `move ${name} outwards by more than ${px(hazard.radius - mineral.radius - apart)}`,
        pointer: `/minerals/${mineral.index}`,
      };
    }
  },
};

/** A mineral too far from every asteroid to be collected. */
export const mineralOutOfReach: Rule = {
  explanation: {
    code: 'mineral-out-of-reach',
    severity: 'warning',
    title: 'a mineral is out of reach of every asteroid',
    why: `${RULE_OF_REACH} So nobody can collect this mineral.`,
    fix: 'Move the mineral and an asteroid nearer to each other, or raise the range.',
  },
  *find({ level, reach }) {
    for (const [i, mineral] of level.minerals.entries()) {
      const words = outOfReach(level, reach, objectName('mineral', i), mineral);
      if (words !== null) yield { ...words, pointer: `/minerals/${i}` };
    }
  },
};

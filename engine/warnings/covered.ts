import { isHazard, staysPut } from './bodies.ts';
import { distance, px } from './numbers.ts';
import { type Disc, overlapsBetween } from './pairs.ts';
import type { Rule } from './warning.ts';

/** Whether all of `disc` lies inside `by`: then who touches the one touches the other. */
export const covers = (by: Disc, disc: Disc): boolean => distance(by, disc) + disc.radius <= by.radius;

/** Touching it is touching something deadly. */
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
          `${body.name} covers the black hole: centres ${px(distance(body, level.blackHole))} apart, ` +
          `radius ${px(body.radius)} against ${px(level.blackHole.radius)}${moves}`,
        hint: `move ${body.name} away from the black hole, or make it smaller`,
        pointer: '/blackHole',
      };
    }
  },
};

/** It can be collected only by dying. */
export const mineralCovered: Rule = {
  explanation: {
    code: 'mineral-covered',
    severity: 'warning',
    title: 'a mineral lies inside something deadly',
    why: 'The whole disc of the mineral lies inside a nova, or inside a hot asteroid that stays where it is: who touches the mineral burns in the same instant.',
    fix: 'Move the mineral out until at least a part of it can be touched from outside.',
  },
  *find({ level, bodies }) {
    const hazards = bodies.filter((body) => staysPut(body, level.recoil));
    if (hazards.length === 0) return;
    const minerals = level.minerals.map((o, i) => ({
      x: o.x,
      y: o.y,
      radius: o.radius,
      name: `minerals[${i}]`,
      pointer: `/minerals/${i}`,
    }));
    const told = new Set<string>();
    for (const [mineral, hazard] of overlapsBetween(minerals, hazards)) {
      if (told.has(mineral.pointer) || !covers(hazard, mineral)) continue;
      told.add(mineral.pointer);
      yield {
        message:
          `${mineral.name} lies inside ${hazard.name}: centres ${px(distance(hazard, mineral))} apart, ` +
          `radius ${px(mineral.radius)} against ${px(hazard.radius)}`,
        hint: `move ${mineral.name} outwards by more than ${px(hazard.radius - mineral.radius - distance(hazard, mineral))}`,
        pointer: mineral.pointer,
      };
    }
  },
};

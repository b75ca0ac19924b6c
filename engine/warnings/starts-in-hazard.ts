import { boxCircleGap, boxOverlapsCircle } from '../contact/index.ts';
import { isHazard, nameOf } from './bodies.ts';
import { px } from './geometry.ts';
import type { Rule } from './warning.ts';

/** She starts inside a hazard, so the run ends at once. */
export const startsInHazard: Rule = {
  explanation: {
    code: 'starts-in-hazard',
    severity: 'warning',
    title: 'the astronaut starts inside something deadly',
    why: 'Her box, upright at the start, overlaps a nova, a hot asteroid or an alien: the run ends as it begins, whatever the player does.',
    fix: 'Move the astronaut or the hazard until her box is clear of it, with a margin for the first turn: the box turns on a press, and its corners are half its diagonal from its centre, 18.9 px.',
  },
  *find({ level, box, bodies }) {
    const { x, y } = level.astronaut;
    for (const body of bodies) {
      if (!isHazard(body) || !boxOverlapsCircle(box, body.x - x, body.y - y, 1, 0, body.radius)) continue;
      const depth = -boxCircleGap(box, body.x - x, body.y - y, 1, 0, body.radius);
      yield {
        message: `the astronaut starts inside ${nameOf(body)}: her box reaches ${px(depth)} into its radius of ${px(body.radius)}`,
        hint: `move the astronaut or ${nameOf(body)} apart by at least ${px(depth)}`,
        pointer: '/astronaut',
      };
    }
  },
};

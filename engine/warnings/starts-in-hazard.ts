import { boxCircleGap, boxOverlapsCircle } from '../contact/index.ts';
import { px } from './geometry.ts';
import type { Rule } from './warning.ts';

/** She starts inside a hazard, so the run ends at once. */
export const startsInHazard: Rule = {
  explanation: {
    code: 'starts-in-hazard',
    severity: 'warning',
    title: 'the astronaut starts inside a hazard',
    why: 'Her collision box, upright at the start, overlaps a nova, a hot asteroid or an alien. Every run ends as it begins, whatever the player does.',
    fix: 'Move the astronaut or the hazard until her box is clear of it, with some room to turn: a press turns the box, and its corners are half its diagonal, 18.9 px, from its centre.',
  },
  *find({ level, box, bodies }) {
    const { x, y } = level.astronaut;
    for (const body of bodies) {
      if (!body.isHazard || !boxOverlapsCircle(box, body.x - x, body.y - y, 1, 0, body.radius)) continue;
      const depth = -boxCircleGap(box, body.x - x, body.y - y, 1, 0, body.radius);
      yield {
        message: `the astronaut starts inside ${body.name}: her box reaches ${px(depth)} into its radius of ${px(body.radius)}`,
        hint: `move the astronaut and ${body.name} apart by at least ${px(depth)}`,
        pointer: '/astronaut',
      };
    }
  },
};

import { boxCircleGap, boxOverlapsCircle } from '../contact/index.ts';
import { px } from './geometry.ts';
import type { Rule } from './warning.ts';

/** She starts at the black hole, so there is nothing to play. */
export const touchesBlackHoleAtStart: Rule = {
  explanation: {
    code: 'touches-black-hole-at-start',
    severity: 'warning',
    title: 'the level is completed as it begins',
    why: 'At the start her collision box touches the black hole. Touching it completes the level, so there is nothing to play.',
    fix: 'Move the astronaut or the black hole until there is some distance between them.',
  },
  *find({ level, box }) {
    const { astronaut, blackHole } = level;
    const dx = blackHole.x - astronaut.x;
    const dy = blackHole.y - astronaut.y;
    if (!boxOverlapsCircle(box, dx, dy, 1, 0, blackHole.radius)) return;
    const depth = px(-boxCircleGap(box, dx, dy, 1, 0, blackHole.radius));
    yield {
      message: `the astronaut starts inside the black hole: her box reaches ${depth} into its radius of ${px(blackHole.radius)}`,
      hint: 'move the astronaut or the black hole away',
      pointer: '/astronaut',
    };
  },
};

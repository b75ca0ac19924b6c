import { objectName } from '../../schema/basics/index.ts';
import { distance, overlaps, px } from './bodies.ts';
import type { Rule } from './warning.ts';

/** Aliens that overlap at the start explode before anyone has seen them. */
export const aliensExplodeAtStart: Rule = {
  explanation: {
    code: 'aliens-explode-at-start',
    severity: 'warning',
    title: 'two aliens touch at the start',
    why: 'Two aliens that touch explode. These two overlap at the start, so they explode as the level begins and never play a part.',
    fix: 'Move them apart by more than the sum of their radii, or delete them.',
  },
  *find({ level }) {
    const aliens = level.aliens.map(({ x, y, radius }, i) => ({ x, y, radius, i }));
    for (const [a, b] of overlaps(aliens)) {
      const reach = a.radius + b.radius;
      yield {
        message: `${objectName('alien', a.i)} and ${objectName('alien', b.i)} explode at the start: their centres are ${px(distance(a, b))} apart, and they touch below ${px(reach)}`,
        hint: `move one of them ${px(reach - distance(a, b))} or more away from the other`,
        pointer: `/aliens/${a.i}`,
      };
    }
  },
};

import { objectName } from '../../schema/index.ts';
import { distance, px } from './geometry.ts';
import { overlaps } from './pairs.ts';
import type { Rule } from './warning.ts';

/** Aliens that overlap at the start explode before anyone has seen them. */
export const aliensExplodeAtStart: Rule = {
  explanation: {
    code: 'aliens-explode-at-start',
    severity: 'warning',
    title: 'two aliens touch at the start',
    why: 'Two aliens that touch explode. These overlap in the level as it stands, so they explode as it begins and never play a part.',
    fix: 'Move them apart, farther than the sum of their radii; or leave them out.',
  },
  *find({ level }) {
    const aliens = level.aliens.map(({ x, y, radius }, i) => ({ x, y, radius, i }));
    for (const [a, b] of overlaps(aliens)) {
      const reach = a.radius + b.radius;
      yield {
        message: `${objectName('alien', a.i)} and ${objectName('alien', b.i)} explode at the start: their centres are ${px(distance(a, b))} apart, and they touch below ${px(reach)}`,
        hint: `move them apart by ${px(reach - distance(a, b))} or more`,
        pointer: `/aliens/${a.i}`,
      };
    }
  },
};

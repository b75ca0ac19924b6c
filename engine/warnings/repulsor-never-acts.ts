import { objectName } from '../../schema/basics/index.ts';
import { covers, distance, overlaps, px } from './bodies.ts';
import type { Rule } from './warning.ts';

/** A repulsor without effect, since an earlier one covers it. */
export const repulsorNeverActs: Rule = {
  explanation: {
    code: 'repulsor-never-acts',
    severity: 'warning',
    title: 'a repulsor lies inside an earlier one',
    why: 'Where repulsors overlap, only the first in the level’s list pushes. This one lies entirely inside an earlier one, so it never pushes.',
    fix: 'Move it out, delete it, or put it before the larger one in the list.',
  },
  *find({ level }) {
    const fields = level.repulsors.map(({ x, y, radius }, i) => ({ x, y, radius, i }));
    const reported = new Set<number>();
    for (const [first, later] of overlaps(fields)) {
      // at the very same place, the warning `same-place` is enough
      if (reported.has(later.i) || distance(first, later) === 0 || !covers(first, later)) continue;
      reported.add(later.i);
      const name = objectName('repulsor', later.i);
      const other = objectName('repulsor', first.i);
      yield {
        message:
          `${name} never pushes: it lies inside ${other}, which comes first in the list ` +
          `(the centres are ${px(distance(first, later))} apart, the radii ${px(later.radius)} and ${px(first.radius)})`,
        hint: `put ${name} before ${other} in the list, move it or delete it`,
        pointer: `/repulsors/${later.i}`,
      };
    }
  },
};

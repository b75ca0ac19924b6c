import { isHazard, LIST_OF, nameOf, pointerOf } from './bodies.ts';
import { covers, distance, px } from './geometry.ts';
import { overlaps } from './pairs.ts';
import type { Rule } from './warning.ts';

/** Solid objects that overlap. Repulsor fields and minerals may lie anywhere; aliens that overlap each other explode. */
export const overlapping: Rule = {
  explanation: {
    code: 'overlapping',
    severity: 'warning',
    title: 'two solid objects overlap',
    why: 'An asteroid, nova, alien or black hole reaches into another. The player sees one shape where there are two and cannot tell which of them acts. The level still works, but this is seldom intended.',
    fix: 'Move them apart. A wall needs no overlap: she does not fit through a gap of less than 20 px.',
  },
  *find({ level, bodies, copies }) {
    // copies are reported by `same-place` and would fill the list here
    const distinct = bodies.filter(({ kind, index }) => kind === 'black hole' || !copies[LIST_OF[kind]].has(index));
    for (const [a, b] of overlaps(distinct)) {
      if (a.kind === 'alien' && b.kind === 'alien') continue;
      if (b.kind === 'black hole' && isHazard(a) && covers(a, level.blackHole)) continue;
      const depth = px(a.radius + b.radius - distance(a, b));
      yield {
        message: `${nameOf(a)} and ${nameOf(b)} overlap by ${depth}: the centres are ${px(distance(a, b))} apart, the radii ${px(a.radius)} and ${px(b.radius)}`,
        hint: `move one of them ${depth} away from the other`,
        pointer: pointerOf(a),
      };
    }
  },
};

import { entryName, listOf, OBJECT_LISTS, objectName } from '../../schema/basics/index.ts';
import { ALL_EFFECTS } from '../effects/index.ts';
import { covers, distance, overlaps, pointerOf, px } from './bodies.ts';
import type { Rule } from './warning.ts';

/** Solid objects that overlap. What is not solid may lie anywhere; chasers that overlap each other explode. */
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
    const distinct = bodies.filter(({ kind, index }) => kind === 'blackHole' || !copies[listOf(kind)].has(index));
    for (const [a, b] of overlaps(distinct)) {
      if (a.kind === b.kind && ALL_EFFECTS.hasChaser(a.kind)) continue;
      if (b.kind === 'blackHole' && a.isHazard && covers(a, level.blackHole)) continue;
      const depth = px(a.radius + b.radius - distance(a, b));
      yield {
        message: `${a.name} and ${b.name} overlap by ${depth}: the centres are ${px(distance(a, b))} apart, the radii ${px(a.radius)} and ${px(b.radius)}`,
        hint: `move one of them ${depth} away from the other`,
        pointer: pointerOf(a),
      };
    }
  },
};

/** A copy that was never moved from its original. */
export const samePlace: Rule = {
  explanation: {
    code: 'same-place',
    severity: 'warning',
    title: 'two objects of one kind have the same centre',
    why: 'Most likely one of them is a copy that was pasted and not moved. The player sees one object, the gun targets the first of two asteroids, and two minerals are collected together.',
    fix: 'Move the second one, or delete it.',
  },
  *find({ copies }) {
    for (const list of OBJECT_LISTS) {
      for (const [i, first] of copies[list]) {
        yield {
          message: `${entryName(list, i)} has the same centre as ${entryName(list, first)}`,
          hint: `move or delete ${entryName(list, i)}`,
          pointer: `/${list}/${i}`,
        };
      }
    }
  },
};

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

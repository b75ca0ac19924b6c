import { entryName, OBJECT_LISTS } from '../../schema/basics/index.ts';
import type { Rule } from './warning.ts';

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

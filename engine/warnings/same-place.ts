import { entryName, OBJECT_LISTS } from '../../schema/index.ts';
import type { Rule } from './warning.ts';

/** A copy that was never moved from its original. */
export const samePlace: Rule = {
  explanation: {
    code: 'same-place',
    severity: 'warning',
    title: 'an object lies exactly on another of its kind',
    why: 'Two objects of one list have the same centre: most likely a copy that was pasted and not moved. The player sees one, the gun targets the first, and two minerals are collected as one.',
    fix: 'Move the second one, or delete it.',
  },
  *find({ copies }) {
    for (const list of OBJECT_LISTS) {
      for (const [i, first] of copies[list]) {
        yield {
          message: `${entryName(list, i)} has the same centre as ${entryName(list, first)}: 0 px apart`,
          hint: `move or delete ${entryName(list, i)}`,
          pointer: `/${list}/${i}`,
        };
      }
    }
  },
};

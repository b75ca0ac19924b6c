import type { Rule } from './warning.ts';

const LISTS = ['asteroids', 'novae', 'repulsors', 'aliens', 'minerals'] as const;

/** A copy that was never moved away. */
export const samePlace: Rule = {
  explanation: {
    code: 'same-place',
    severity: 'warning',
    title: 'an object lies exactly on another of its kind',
    why: 'Two objects of one list have the same centre: most likely a copy that was pasted and not moved. The player sees one, the gun targets the first, and two minerals are collected as one.',
    fix: 'Move the second one, or delete it.',
  },
  *find({ level }) {
    for (const list of LISTS) {
      const first = new Map<string, number>();
      for (const [i, { x, y }] of level[list].entries()) {
        const place = `${x} ${y}`;
        const other = first.get(place);
        if (other === undefined) {
          first.set(place, i);
          continue;
        }
        yield {
          message: `${list}[${i}] has the same centre as ${list}[${other}]: 0 px apart`,
          hint: `move or delete ${list}[${i}]`,
          pointer: `/${list}/${i}`,
        };
      }
    }
  },
};

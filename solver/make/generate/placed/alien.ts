import { KINDS } from '../../../../schema/basics/index.ts';
import { distance, type PlacedKind } from './placed-kind.ts';

/** px between an alien and all other objects, at least. */
const ROOM = 40;

/** The radius that every alien gets, px: the usual one. */
export const ALIEN = KINDS.alien.fields.radius.default as number;

/** It sleeps when she starts. */
export const alien = {
  kind: 'alien',
  list: 'aliens',
  isUsual: true,
  isSolid: true,
  turn: 0,
  make({ inPlay, isFree, start, rules }) {
    const made = { ...inPlay(), radius: ALIEN };
    return distance(made, start) >= rules.alienSight + ALIEN && isFree(made, ROOM) ? made : null;
  },
} as const satisfies PlacedKind;

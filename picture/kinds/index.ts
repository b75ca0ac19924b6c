import type { ObjectKind, ObjectOf } from '../../schema/index.ts';
import { alien } from './alien.ts';
import { asteroid } from './asteroid.ts';
import { astronaut } from './astronaut.ts';
import { blackHole } from './black-hole.ts';
import type { KindInPicture } from './kind-in-picture.ts';
import { mineral } from './mineral.ts';
import { nova } from './nova.ts';
import { repulsor } from './repulsor.ts';
import { wind } from './wind.ts';
import { wormhole } from './wormhole.ts';

export { ALIEN_INK } from './alien.ts';
export { drawAstronaut } from './astronaut.ts';
export type { Look } from './kind-in-picture.ts';

const DRAWINGS: { readonly [K in ObjectKind]: KindInPicture<ObjectOf<K>> } = {
  astronaut,
  blackHole,
  asteroid,
  nova,
  repulsor,
  alien,
  mineral,
  wind,
  wormhole,
};

/** The drawing of each kind of object. */
export const IN_PICTURE: Readonly<Record<ObjectKind, KindInPicture>> = DRAWINGS;

import type { ObjectKind } from '../../../schema/index.ts';
import { alien } from './alien.ts';
import { asteroid } from './asteroid.ts';
import { astronaut } from './astronaut.ts';
import { blackHole } from './black-hole.ts';
import type { KindOnCanvas, Sign } from './kind-on-canvas.ts';
import { mineral } from './mineral.ts';
import { nova } from './nova.ts';
import { repulsor } from './repulsor.ts';
import { wind } from './wind.ts';
import { wormhole } from './wormhole.ts';

export { type Figure, put } from './kind-on-canvas.ts';

/** How each kind of object is drawn on the canvas. */
export const ON_CANVAS: Readonly<Record<ObjectKind, KindOnCanvas>> = {
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

/** The icon of a kind or of its variant. */
export const signOf = (kind: ObjectKind, isVariant: boolean): Sign => {
  const { sign, variantSign } = ON_CANVAS[kind];
  return isVariant ? (variantSign ?? sign) : sign;
};

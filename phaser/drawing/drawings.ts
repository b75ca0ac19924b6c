import type { ObjectKind } from '../../schema/basics/index.ts';
import { alien } from './alien.ts';
import { asteroid } from './asteroid.ts';
import { astronaut } from './astronaut.ts';
import { blackHole } from './black-hole.ts';
import type { KindDrawing } from './kind-drawing.ts';
import { mineral } from './mineral.ts';
import { nova } from './nova.ts';
import { repulsor } from './repulsor.ts';
import { wind } from './wind.ts';
import { wormhole } from './wormhole.ts';

/** How each kind of object is drawn. */
export const DRAWINGS = {
  astronaut,
  blackHole,
  asteroid,
  nova,
  repulsor,
  alien,
  mineral,
  wind,
  wormhole,
} satisfies Readonly<Record<ObjectKind, KindDrawing<never>>>;

import { OBJECT_KINDS } from '../../../schema/basics/index.ts';
import type { KindSkin, Skin } from '../skin.ts';
import { astronaut, ghost, trail } from './astronaut.ts';
import { background } from './background.ts';
import { beam } from './beam.ts';
import { effects } from './effects.ts';
import { alien, asteroid, mineral } from './kinds.ts';
import { drawKind } from './pieces.ts';

const inPlace = Object.fromEntries(OBJECT_KINDS.map((kind) => [kind, drawKind(kind)])) as unknown as KindSkin;

/** How levels look if a game does not say otherwise: textures that are drawn at run time, no files. */
export const DEFAULT_SKIN: Skin = {
  ...inPlace,
  background,
  astronaut,
  asteroid,
  alien,
  mineral,
  beam,
  trail,
  ghost,
  effects,
};

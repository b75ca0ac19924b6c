import type { ThemeName } from '../generator-spec.ts';
import { corridors } from './corridors.ts';
import { fields } from './fields.ts';
import { lures } from './lures.ts';
import { orbits } from './orbits.ts';
import { slings } from './slings.ts';
import type { Theme } from './theme.ts';

export { type Flight, flightOf } from './flight.ts';
export { ASIDE } from './lures.ts';
export { Site } from './site.ts';
export { bestImage, type Image, partnerOf, symmetryOf, withImages, withoutSingles } from './symmetry.ts';
export { isOnTheme, PLAIN_STAGE, type Stage, type Theme } from './theme.ts';

/** The themes by name. */
export const THEMES: Readonly<Record<ThemeName, Theme>> = { orbits, corridors, slings, lures, fields };

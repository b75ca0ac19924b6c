import type { LevelFile } from '../../../schema/index.ts';
import type { Recipe } from '../document.ts';
import { LIST_OF_KIND, plainList } from '../objects.ts';

/** What can be placed; a hot asteroid is an asteroid. */
export type PlacedKind = keyof typeof LIST_OF_KIND | 'hot';

/** Radii that new objects get where the format has no default, px: the original's smaller ones. */
const NEW_RADIUS = { asteroid: 16, hot: 16, nova: 16, repulsor: 32 } as const;

type Objects = NonNullable<LevelFile['asteroids']>[number];

/** A new object at a place in px; its id comes from what it is and where. @param radius px; when left out the usual one of its kind */
export function addObject(kind: PlacedKind, x: number, y: number, radius?: number): Recipe {
  return (draft) => {
    const list = LIST_OF_KIND[kind === 'hot' ? 'asteroid' : kind];
    const size = radius ?? (kind in NEW_RADIUS ? NEW_RADIUS[kind as keyof typeof NEW_RADIUS] : undefined);
    const object = { x, y, ...(size === undefined ? {} : { radius: size }), ...(kind === 'hot' ? { hot: true } : {}) };
    // all lists hold circles; the kinds whose radius may be missing are those that got none
    draft[list] = [...plainList(draft, list), object] as Objects[];
  };
}

import type { Textures } from 'phaser';
import { drawTextures as drawShared, drawStarTiles, type Theme } from '../../../phaser/index.ts';

export { STAR_TILE, TEXTURE_UNIT } from '../../../phaser/index.ts';

/** Phaser keeps copies of the tiles, so each theme has its own, which is never redrawn. */
export const starsOf = (theme: Theme, layer: 'far' | 'near'): string => `stars-${layer}-${theme}`;

/** Draws all textures. Those of the previous theme are drawn again in place, so that images that use them stay valid. */
export function drawTextures(textures: Textures.TextureManager, theme: Theme): void {
  drawShared(textures, theme, (name) => name);
  drawStarTiles(textures, theme, starsOf(theme, 'far'), starsOf(theme, 'near'));
}

import type { Textures } from 'phaser';
import { type Brush, TEXTURE_UNIT } from '../brush.ts';
import { COLOURS, type Theme } from '../colours.ts';
import { ON_CANVAS } from '../kinds/index.ts';
import { drawGlow, drawSpark } from './light.ts';
import { drawHaze, drawStars } from './space.ts';

export { TEXTURE_UNIT } from '../brush.ts';

/** side of a tile of stars, px */
export const STAR_TILE = 512;
/** Phaser keeps copies of the tiles, so each theme has its own, which is never redrawn. */
export const starsOf = (theme: Theme, layer: 'far' | 'near'): string => `stars-${layer}-${theme}`;

/** The empty canvas of a texture. It is not from Phaser's pool, as a pooled canvas may be opaque from earlier use. */
function emptied(textures: Textures.TextureManager, name: string, size: number): Textures.CanvasTexture | null {
  if (textures.exists(name)) {
    const there = textures.get(name) as Textures.CanvasTexture;
    there.context.clearRect(0, 0, size, size);
    return there;
  }
  const canvas = document.createElement('canvas');
  canvas.width = size;
  canvas.height = size;
  return textures.addCanvas(name, canvas);
}

/**
 * Draws all textures and registers them with Phaser. Textures of the previous theme are redrawn in place, so that images that
 * use them stay valid.
 */
export function drawTextures(textures: Textures.TextureManager, theme: Theme): void {
  const colours = COLOURS[theme];
  const texture = (name: string, size: number, draw: (brush: Brush) => void) => {
    const made = emptied(textures, name, size);
    if (made === null) return;
    made.context.save();
    draw(made.context);
    made.context.restore();
    made.refresh();
  };
  const object = (name: string, draw: (brush: Brush) => void) =>
    texture(name, 2 * TEXTURE_UNIT, (brush) => {
      brush.translate(TEXTURE_UNIT, TEXTURE_UNIT);
      brush.scale(TEXTURE_UNIT, TEXTURE_UNIT);
      draw(brush);
    });

  for (const { textures } of Object.values(ON_CANVAS)) {
    for (const [name, draw] of Object.entries(textures)) object(name, (brush) => draw(brush, colours, theme));
  }
  object('glow', (brush) => drawGlow(brush, colours.nova));
  object('spark', drawSpark);
  object('haze', (brush) => drawHaze(brush, colours));
  if (textures.exists(starsOf(theme, 'far'))) return;
  texture(starsOf(theme, 'far'), STAR_TILE, (brush) => drawStars(brush, colours, STAR_TILE, 160, 1.1, 3));
  texture(starsOf(theme, 'near'), STAR_TILE, (brush) => drawStars(brush, colours, STAR_TILE, 40, 1.9, 11));
}

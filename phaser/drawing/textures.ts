import type { Textures } from 'phaser';
import type { ObjectKind } from '../../schema/basics/index.ts';
import { alien } from './alien.ts';
import { asteroid } from './asteroid.ts';
import { astronaut } from './astronaut.ts';
import { blackHole } from './black-hole.ts';
import { type Brush, dice, disc, drawGlow, drawSpark, fadingDisc, faint, TEXTURE_UNIT } from './brush.ts';
import { GAME_COLOURS, type GameColours, type Theme } from './colours.ts';
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

/** side of a tile of stars, px */
export const STAR_TILE = 512;

/** A canvas of its own: those of Phaser's pool may be opaque from earlier use. */
function canvasOf(size: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = size;
  canvas.height = size;
  return canvas;
}

/**
 * Draws a texture and registers it with Phaser. One that exists is drawn again in place, so that images that use it stay valid.
 *
 * @param draw - draws on an empty square; the brush's unit is a px and its origin the upper left corner
 */
function drawTexture(textures: Textures.TextureManager, key: string, size: number, draw: (brush: Brush) => void): void {
  const made = textures.exists(key) ? (textures.get(key) as Textures.CanvasTexture) : textures.addCanvas(key, canvasOf(size));
  if (made === null) return;
  made.context.clearRect(0, 0, size, size);
  made.context.save();
  draw(made.context);
  made.context.restore();
  made.refresh();
}

/** Draws a texture whose brush has its origin in the middle and half of the side as its unit. */
export function drawRound(textures: Textures.TextureManager, key: string, draw: (brush: Brush) => void): void {
  drawTexture(textures, key, 2 * TEXTURE_UNIT, (brush) => {
    brush.translate(TEXTURE_UNIT, TEXTURE_UNIT);
    brush.scale(TEXTURE_UNIT, TEXTURE_UNIT);
    draw(brush);
  });
}

/**
 * Draws the textures of all objects, of light and of space.
 *
 * @param textures - the textures of the game
 * @param theme - whose colours are used
 * @param keyOf - the key of a texture by its name
 */
export function drawTextures(textures: Textures.TextureManager, theme: Theme, keyOf: (name: string) => string): void {
  const colours = GAME_COLOURS[theme];
  for (const drawing of Object.values(DRAWINGS)) {
    for (const [name, draw] of Object.entries(drawing.textures)) {
      drawRound(textures, keyOf(name), (brush) => draw(brush, colours, theme));
    }
  }
  drawRound(textures, keyOf('glow'), (brush) => drawGlow(brush, colours.nova));
  drawRound(textures, keyOf('spark'), drawSpark);
  drawRound(textures, keyOf('haze'), (brush) => drawHaze(brush, colours));
}

/**
 * Draws the two tiles of stars, unless they exist.
 *
 * @param textures - the textures of the game
 * @param theme - whose colours are used
 * @param far - the key of the tile with small stars
 * @param near - the key of the tile with large stars
 */
export function drawStarTiles(textures: Textures.TextureManager, theme: Theme, far: string, near: string): void {
  if (textures.exists(far)) return;
  const colours = GAME_COLOURS[theme];
  drawTexture(textures, far, STAR_TILE, (brush) => drawStars(brush, colours, STAR_TILE, 160, 1.1, 3));
  drawTexture(textures, near, STAR_TILE, (brush) => drawStars(brush, colours, STAR_TILE, 40, 1.9, 11));
}

/** A seamless tile of stars; few of them are large. Here the brush uses px. */
function drawStars(brush: Brush, colours: GameColours, size: number, count: number, biggest: number, seed: number): void {
  const roll = dice(seed);
  for (let i = 0; i < count; i++) {
    const x = size * roll();
    const y = size * roll();
    const radius = 0.4 + (biggest - 0.4) * roll() ** 4;
    brush.fillStyle = faint(colours.star, 0.25 + 0.65 * roll());
    disc(brush, x, y, radius);
  }
}

/** A soft tinted cloud, drawn large behind everything. */
function drawHaze(brush: Brush, colours: GameColours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.haze, 0.9)],
    [0.5, faint(colours.haze, 0.35)],
    [1, faint(colours.haze, 0)],
  ]);
}

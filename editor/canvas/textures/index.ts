import type { Textures } from 'phaser';
import type { Colours } from '../colours.ts';
import { drawAlien, drawAstronaut, drawMineral, drawPupil, drawSpark } from './beings.ts';
import type { Brush } from './brush.ts';
import { drawGlow, drawHotRock, drawRock } from './rock.ts';
import { drawBlackHole, drawHaze, drawNova, drawRepulsor, drawStars } from './space.ts';

/** Half of a texture's side, px: what the unit circle of its drawing is on it. */
export const TEXTURE_UNIT = 64;
/** Side of a tile of stars, px. */
export const STAR_TILE = 512;
/** Asteroids come in so many shapes. */
export const ROCKS = 4;

/** Draws all textures by code and puts them where Phaser finds them; those of the last theme are replaced. */
export function drawTextures(textures: Textures.TextureManager, colours: Colours): void {
  const texture = (name: string, size: number, draw: (brush: Brush) => void) => {
    if (textures.exists(name)) textures.remove(name);
    const made = textures.createCanvas(name, size, size);
    if (made === null) return;
    draw(made.context);
    made.refresh();
  };
  const object = (name: string, draw: (brush: Brush) => void) =>
    texture(name, 2 * TEXTURE_UNIT, (brush) => {
      brush.translate(TEXTURE_UNIT, TEXTURE_UNIT);
      brush.scale(TEXTURE_UNIT, TEXTURE_UNIT);
      draw(brush);
    });

  for (let i = 0; i < ROCKS; i++) {
    object(`rock-${i}`, (brush) => drawRock(brush, colours, 7 + 13 * i));
    object(`hot-${i}`, (brush) => drawHotRock(brush, colours, 5 + 17 * i));
  }
  object('glow', (brush) => drawGlow(brush, colours.nova));
  object('nova', (brush) => drawNova(brush, colours));
  object('black-hole', (brush) => drawBlackHole(brush, colours));
  object('repulsor', (brush) => drawRepulsor(brush, colours));
  object('alien', (brush) => drawAlien(brush, colours));
  object('pupil', drawPupil);
  object('mineral', (brush) => drawMineral(brush, colours));
  object('astronaut', (brush) => drawAstronaut(brush, colours));
  object('spark', drawSpark);
  object('haze', (brush) => drawHaze(brush, colours));
  texture('stars-far', STAR_TILE, (brush) => drawStars(brush, colours, STAR_TILE, 160, 1.1, 3));
  texture('stars-near', STAR_TILE, (brush) => drawStars(brush, colours, STAR_TILE, 40, 1.9, 11));
}

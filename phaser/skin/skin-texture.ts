import type { Scene } from 'phaser';
import {
  type Brush,
  DRAWINGS,
  disc,
  drawRound,
  drawSpark,
  drawStarTiles,
  drawTextures,
  faint,
  GAME_COLOURS,
  ring,
} from '../drawing/index.ts';

const THEME = 'dark';

/** The key of a texture of the default skin. */
const keyOf = (name: string): string => `gravity-quest:${name}`;

/** A beam along the x axis, as long and as wide as the texture; white, to be coloured. */
function drawBeam(brush: Brush): void {
  const across = brush.createLinearGradient(0, -1, 0, 1);
  for (const [at, alpha] of [
    [0, 0],
    [0.25, 0.12],
    [0.38, 0.3],
    [0.44, 0.95],
    [0.56, 0.95],
    [0.62, 0.3],
    [0.75, 0.12],
    [1, 0],
  ]) {
    across.addColorStop(at, faint('#ffffff', alpha));
  }
  brush.fillStyle = across;
  brush.fillRect(-1, -1, 2, 2);
}

/** A closed lid over the eye of an alien. */
function drawLid(brush: Brush): void {
  const { alien, alienShade } = GAME_COLOURS[THEME];
  brush.fillStyle = alien;
  disc(brush, 0, -0.05, 0.44);
  brush.strokeStyle = alienShade;
  brush.lineWidth = 0.07;
  brush.lineCap = 'round';
  brush.beginPath();
  brush.arc(0, -0.14, 0.34, 0.16 * Math.PI, 0.84 * Math.PI);
  brush.stroke();
}

const NAMES: ReadonlySet<string> = new Set([
  ...Object.values(DRAWINGS).flatMap(({ textures }) => Object.keys(textures)),
  ...['glow', 'spark', 'haze', 'stars-far', 'stars-near', 'lid'],
]);

/**
 * Draws the textures of the default skin, unless the game has them. They stay as long as the game, like loaded files.
 * @returns the key of one of them
 */
export function skinTexture({ textures }: Scene, name: string): string {
  if (!NAMES.has(name)) {
    throw new RangeError(`texture: expected one of ${[...NAMES].join(', ')}; found ${JSON.stringify(name)}.`);
  }
  if (!textures.exists(keyOf('lid'))) {
    drawTextures(textures, THEME, keyOf);
    drawStarTiles(textures, THEME, keyOf('stars-far'), keyOf('stars-near'));
    drawRound(textures, keyOf('lid'), drawLid);
    // smooth, also in a game of pixel art
    for (const one of NAMES) textures.get(keyOf(one)).setFilter(0);
  }
  return keyOf(name);
}

/** What is drawn in several colours, each with the share that its own colours give way. */
const COLOURED: Readonly<Record<string, { readonly share: number; readonly draw: (brush: Brush) => void }>> = {
  astronaut: { share: 0.6, draw: (brush) => DRAWINGS.astronaut.textures.astronaut(brush, GAME_COLOURS[THEME], THEME) },
  beam: { share: 1, draw: drawBeam },
  ring: { share: 1, draw: (brush) => ring(brush, 0.95, 0.06, '#ffffff') },
  mark: { share: 1, draw: (brush) => ring(brush, 0.95, 0.035, '#ffffff') },
  spark: { share: 1, draw: drawSpark },
};

/**
 * Draws a texture in a colour, unless the game has it. A tint would do on WebGL, but not on a plain canvas.
 * @param colour `#rrggbb`
 * @returns its key
 */
export function colouredTexture({ textures }: Scene, name: keyof typeof COLOURED, colour: string): string {
  const key = keyOf(`${name}-${colour.slice(1)}`);
  if (textures.exists(key)) return key;
  const { share, draw } = COLOURED[name];
  drawRound(textures, key, (brush) => {
    draw(brush);
    brush.globalCompositeOperation = 'source-atop';
    brush.globalAlpha = share;
    brush.fillStyle = colour;
    brush.fillRect(-1, -1, 2, 2);
  });
  textures.get(key).setFilter(0);
  return key;
}

export { type Brush, dice, disc, drawSpark, faint, ring, TEXTURE_UNIT } from './brush.ts';
export { colourNumber, GAME_COLOURS, type GameColours, type Theme } from './colours.ts';
export { DRAWINGS } from './drawings.ts';
export type { DrawTexture, KindDrawing, Part } from './kind-drawing.ts';
export { drawRound, drawStarTiles, drawTextures, STAR_TILE } from './textures.ts';

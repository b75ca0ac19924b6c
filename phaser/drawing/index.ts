export { type Brush, dice, disc, drawSpark, faint, ring, TEXTURE_UNIT } from './brush.ts';
export { colourNumber, GAME_COLOURS, type GameColours, type Theme } from './colours.ts';
export type { DrawTexture, KindDrawing, Part } from './kind-drawing.ts';
export { DRAWINGS, drawRound, drawStarTiles, drawTextures, STAR_TILE } from './textures.ts';

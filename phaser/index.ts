export { browserStorage } from './browser-storage.ts';
export {
  type Brush,
  colourNumber,
  DRAWINGS,
  type DrawTexture,
  drawStarTiles,
  drawTextures,
  faint,
  GAME_COLOURS,
  type GameColours,
  type KindDrawing,
  type Part,
  ring,
  STAR_TILE,
  TEXTURE_UNIT,
  type Theme,
} from './drawing/index.ts';
export { type LinkedText, levelFragment, levelTextOf } from './links/index.ts';
export { type Area, type CameraMode, createRunner, type InputOptions, type Runner, type RunnerOptions } from './runner/index.ts';
export { type GravityQuestPlugin, makePlugin, type PhaserLike, type PluginClass } from './scene-plugin.ts';
export { DEFAULT_SKIN, type Draw, type Figure, type KindSkin, type Skin, type SkinStage, type View } from './skin/index.ts';

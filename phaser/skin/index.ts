export { DEFAULT_SKIN } from './default/index.ts';
export type { Draw, Figure, KindSkin, Skin, SkinStage, View } from './skin.ts';
export { skinTexture } from './skin-texture.ts';

export { drawPacks } from './draw-packs.ts';

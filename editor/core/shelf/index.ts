export { type DeathMap, deathsNear } from './death-map.ts';
export {
  bareTitle,
  type GivenPlay,
  isPlayFile,
  isPlayText,
  PLAY_EXTENSION,
  playInFragment,
  playsInText,
  type RefusedFile,
  readPlayFiles,
} from './given.ts';
export { hashNow } from './level-now.ts';
export { type OpenedPlay, shelfOf } from './shelf.ts';

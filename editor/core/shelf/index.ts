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
export { type DeathMap, deathsNear, hashNow, type OpenedPlay, shelfOf } from './shelf.ts';

// The game for bundles that are small: the same functions, and those parts of the game that levels call for.
export { aliens, type GamePart, manyObjects, recoil, repulsors, winds, wormholes } from '../../engine/light/index.ts';
export {
  type PlainLevelReading as LevelReading,
  type ReadPlainLevelOptions as ReadLevelOptions,
  readPlainLevel as readLevel,
} from '../../schema/plain/index.ts';
export { type CreateLightPlayer, composePlayer, type LightPlayerOptions } from './compose-player.ts';

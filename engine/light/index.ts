// The engine in parts, for games that are small. `engine/index.ts` has all of it.
export { aliens, type GamePart, manyObjects, recoil, repulsors, winds, wormholes } from '../effects/index.ts';
export { composeEngine } from './compose-engine.ts';

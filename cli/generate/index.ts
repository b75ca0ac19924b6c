export { generatedPath, type KeptPack, keepLevel, keepPack, makeDirectory, packPath } from './keep-level.ts';
export type { GenerateTask, MadeLevel } from './make-level.ts';
export { makeLevels } from './make-levels.ts';
export { makePack } from './make-pack.ts';

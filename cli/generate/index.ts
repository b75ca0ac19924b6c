export { generatedPath, keepLevel, makeDirectory } from './keep-level.ts';
export type { GenerateTask, MadeLevel } from './make-level.ts';
export { makeLevels } from './make-levels.ts';

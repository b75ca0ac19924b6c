// What engine, game, options and reports need of the schema. The schema itself loads zod, which takes as long as starting node
// and is larger than the engine.

export { pointerFile } from '../json/pointer-file.ts';
export { MAX_FILE_SIZE } from '../json/read-json.ts';
export { strictJson } from '../json/strict-json.ts';
export { closestName } from './closest-name.ts';
export { DEFAULT_RULES, type OwnRules, ownRules, RULE_NAMES, type RuleName, type Rules, rulesOf } from './default-rules.ts';
export * from './kinds.ts';
export * from './level-types.ts';
export { LIMITS } from './limits.ts';
export { entryName, objectName, touchedName } from './names.ts';
export { objectsIn } from './objects-in.ts';
export { LONGEST_RUN, MOST_WORK } from './terms-limits.ts';

// What engine, game, options and reports need of the schema. The schema itself loads zod, which takes as long as starting node
// and is larger than the engine.
export { closestName } from '../closest-name.ts';
export { codeFrame } from '../code-frame.ts';
export { DEFAULT_RULES, type OwnRules, ownRules, RULE_NAMES, type RuleName, type Rules, rulesOf } from '../default-rules.ts';
export * from '../kinds.ts';
export * from '../level-types.ts';
export { LIMITS } from '../limits.ts';
export { entryName, objectName, touchedName } from '../names.ts';
export { objectsIn } from '../objects-in.ts';
export { pointerFile } from '../pointer-file.ts';
export { MAX_FILE_SIZE } from '../read-json.ts';
export { strictJson } from '../strict-json.ts';
export { LONGEST_RUN, MOST_WORK } from '../terms-limits.ts';

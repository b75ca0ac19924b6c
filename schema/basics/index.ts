// What levels are made of, with limits and words; engine, game, options and reports need no more of the schema. The schema itself
// loads zod, which takes as long as starting node and is larger than the engine.

export * from './adjustable.ts';
export { CODES, type CodeExplanation } from './codes.ts';
export { DEFAULT_RULES, type OwnRules, ownRules, RULE_NAMES, type RuleName, type Rules, rulesOf } from './default-rules.ts';
export * from './kinds.ts';
export * from './level-types.ts';
export * from './limits.ts';
export { entryName, objectName, touchedName, toWords } from './names.ts';
export * from './problem.ts';
export { closestName, formatValue, quote } from './words.ts';

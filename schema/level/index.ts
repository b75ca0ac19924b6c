// A level file: its shape, what contradicts itself in it, its defaults, its words and its layout. No zod.

export { checkMeaning, checkShape } from './check-shape.ts';
export { contradictionsIn, type Fault, findFaults, fits } from './faults.ts';
export { formatLevel } from './format.ts';
export { withIds } from './ids.ts';
export { conflictProblems } from './merge-conflicts.ts';
export { type JsonObject, MIGRATIONS, type Migration, migrate, readVersion } from './migrate.ts';
export { type LevelDocument, type LevelReading, type ReadLevelOptions, readContent, readLevel } from './read-level.ts';
export { type ReadRunTextOptions, readRunText } from './read-run-text.ts';
export { enteringFolder, leavingFolder, resolveLevel } from './resolve.ts';
export { type GameRule, RULES } from './rules.ts';
export * from './run-text.ts';
export {
  type FileConflict,
  flag,
  formatLevelShape,
  LEVEL_SHAPE,
  type LevelFile,
  LINE_BREAK,
  listOf,
  NOTE_TEXT,
  notesInOrder,
  number,
  object,
  objectsOfFile,
  oneOf,
  optional,
  orNull,
  RULES_SHAPE,
  type Shape,
  shapeOfObject,
  text,
  type ValueOf,
} from './shape.ts';
export { codeFinding, found, tellFaults, unknownKey, unknownValue, wrongType } from './shape-findings.ts';
export { LEVEL_WORDS, type Words } from './words.ts';

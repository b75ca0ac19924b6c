export {
  ADJUSTABLE_CODES,
  ADJUSTMENTS,
  type AdjustableCode,
  type Adjustment,
  ALLOWABLE_CODES,
  type AllowableCode,
} from './basics/adjustable.ts';
export { closestName } from './basics/closest-name.ts';
export { adjustmentOf, CODES, type CodeExplanation } from './basics/codes.ts';
export { DEFAULT_RULES, type OwnRules, RULE_NAMES, type RuleName, type Rules, rulesOf } from './basics/default-rules.ts';
export type { Appearance, Field, FlagField, Kind, NumberField, Pair } from './basics/kind.ts';
export * from './basics/kinds.ts';
export { DEFAULT_RANGE, LEVEL_VERSION } from './basics/level-constants.ts';
export * from './basics/level-types.ts';
export { LIMITS } from './basics/limits.ts';
export { entryName, objectName, touchedName } from './basics/names.ts';
export type { Problem } from './basics/problem.ts';
export {
  ACCURACY_NAMES,
  type ConfigFile,
  type ConfiguredSeverity,
  configSchema,
  REPORTER_NAMES,
  type ReporterName,
  SEVERITIES,
  type SeverityMap,
} from './config/config.ts';
export { type ConfigReading, readConfig } from './config/read-config.ts';
export * from './edit-api.ts';
export {
  exportOriginal,
  formatOriginal,
  type OriginalExport,
  type OriginalLevel,
  type TitledOriginal,
} from './exchange/export-original.ts';
export { type ImportedLevel, type ImportReading, importOriginal } from './exchange/import-original.ts';
export {
  exportTiled,
  formatTiled,
  formatTmx,
  type ImportTiledOptions,
  importTiled,
  isTiledMap,
  type TiledLayer,
  type TiledMap,
  type TiledObject,
  type TiledProperty,
} from './exchange/tiled/index.ts';
export { codeFrame } from './json/code-frame.ts';
export { MAX_FILE_SIZE } from './json/read-json.ts';
export { isSame } from './json/same-json.ts';
export type { TextPlace } from './json/text-place.ts';
export { configJsonSchema, formatConfigJsonSchema, formatLevelJsonSchema, levelJsonSchema } from './json-schema.ts';
export { enteringFolder, leavingFolder } from './level/folder-rules.ts';
export { formatLevel } from './level/format.ts';
export { withIds } from './level/ids.ts';
export { conflictProblems } from './level/merge-conflicts.ts';
export type { JsonObject, Migration } from './level/migrate.ts';
export { LINE_BREAK, NOTE_TEXT, notesInOrder } from './level/notes.ts';
export { type LevelDocument, type LevelReading, type ReadLevelOptions, readLevel } from './level/read-level.ts';
export { resolveLevel } from './level/resolve.ts';
export { type GameRule, RULES } from './level/rules.ts';
export * from './level/run-text/index.ts';
export { type FileConflict, formatLevelShape, type LevelFile } from './level/shape.ts';
export { levelSchema, OBJECT_SCHEMAS, rulesSchema } from './level-schema.ts';
export {
  formatLock,
  formatLockJsonSchema,
  LOCK_NAME,
  LOCK_VERSION,
  type Lock,
  type LockEntry,
  lockEntrySchema,
  lockJsonSchema,
  lockSchema,
} from './lock/lock.ts';
export { type LockReading, readLock } from './lock/read-lock.ts';
export {
  formatPack,
  formatPackJsonSchema,
  levelOfEntry,
  levelsOfPack,
  PACK_NAME,
  PACK_VERSION,
  type PackEntry,
  type PackFile,
  packJsonSchema,
  packSchema,
} from './pack/pack.ts';
export { type PackReading, readPack } from './pack/read-pack.ts';
export { type EditorPlace, type PlaceReading, placeFragment, placeIn } from './place-link.ts';
export * from './reports/check.ts';
export { type DiffReport, diffReportSchema } from './reports/diff.ts';
export { type FixReport, fixReportSchema } from './reports/fix.ts';
export { type FitReport, type ForecastReport, fitReportSchema, forecastReportSchema } from './reports/forecast.ts';
export * from './reports/others.ts';
export { type TermsReport, termsReportSchema } from './reports/parts.ts';
export { formatReportJsonSchema, REPORT_SCHEMAS, type ReportName, reportJsonSchema } from './reports/schemas.ts';
export { type TuneReport, tuneReportSchema } from './reports/tune.ts';
export { type VerifyReport, verifyReportSchema } from './reports/verify.ts';

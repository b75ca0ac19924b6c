export {
  ADJUSTABLE_CODES,
  ADJUSTMENTS,
  type AdjustableCode,
  type Adjustment,
  ALLOWABLE_CODES,
  type AllowableCode,
} from './adjustable.ts';
export { closestName } from './closest-name.ts';
export { codeFrame } from './code-frame.ts';
export { adjustmentOf, CODES, type CodeExplanation } from './codes.ts';
export {
  ACCURACY_NAMES,
  type ConfigFile,
  type ConfiguredSeverity,
  configSchema,
  REPORTER_NAMES,
  type ReporterName,
  SEVERITIES,
  type SeverityMap,
} from './config.ts';
export { DEFAULT_RULES, type OwnRules, RULE_NAMES, type RuleName, type Rules, rulesOf } from './default-rules.ts';
export { type DiffReport, diffReportSchema } from './diff-report.ts';
export * from './edit-api.ts';
export {
  exportOriginal,
  formatOriginal,
  type OriginalExport,
  type OriginalLevel,
  type TitledOriginal,
} from './export-original.ts';
export { type FixReport, fixReportSchema } from './fix-report.ts';
export { enteringFolder, leavingFolder } from './folder-rules.ts';
export { type FitReport, type ForecastReport, fitReportSchema, forecastReportSchema } from './forecast-report.ts';
export { formatLevel } from './format.ts';
export { withIds } from './ids.ts';
export { type ImportedLevel, type ImportReading, importOriginal } from './import-original.ts';
export { configJsonSchema, formatConfigJsonSchema, formatLevelJsonSchema, levelJsonSchema } from './json-schema.ts';
export type { Appearance, Field, FlagField, Kind, NumberField, Pair } from './kind.ts';
export * from './kinds.ts';
export { levelSchema, OBJECT_SCHEMAS, rulesSchema } from './level.ts';
export { DEFAULT_RANGE, LEVEL_VERSION } from './level-constants.ts';
export { type FileConflict, formatLevelShape, type LevelFile } from './level-shape.ts';
export * from './level-types.ts';
export { LIMITS } from './limits.ts';
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
} from './lock.ts';
export { conflictProblems } from './merge-conflicts.ts';
export type { JsonObject, Migration } from './migrate.ts';
export { entryName, objectName, touchedName } from './names.ts';
export { LINE_BREAK, NOTE_TEXT, notesInOrder } from './notes.ts';
export * from './other-reports.ts';
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
} from './pack.ts';
export { type EditorPlace, type PlaceReading, placeFragment, placeIn } from './place-link.ts';
export type { Problem } from './problem.ts';
export { type ConfigReading, readConfig } from './read-config.ts';
export { MAX_FILE_SIZE } from './read-json.ts';
export { type LevelDocument, type LevelReading, type ReadLevelOptions, readLevel } from './read-level.ts';
export { type LockReading, readLock } from './read-lock.ts';
export { type PackReading, readPack } from './read-pack.ts';
export * from './report.ts';
export { type TermsReport, termsReportSchema } from './report-parts.ts';
export { formatReportJsonSchema, REPORT_SCHEMAS, type ReportName, reportJsonSchema } from './report-schemas.ts';
export { resolveLevel } from './resolve.ts';
export { type GameRule, RULES } from './rules.ts';
export * from './run-text/index.ts';
export { isSame } from './same-json.ts';
export type { TextPlace } from './text-place.ts';
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
} from './tiled/index.ts';
export { type TuneReport, tuneReportSchema } from './tune-report.ts';
export { type VerifyReport, verifyReportSchema } from './verify-report.ts';

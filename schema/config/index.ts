// The configuration of a folder.
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
export { type ConfigReading, readConfig } from './read-config.ts';

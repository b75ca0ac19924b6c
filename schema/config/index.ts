// The configuration of a folder.
export { type ConfigFile, configSchema, type SeverityMap } from './config.ts';
export { ACCURACY_NAMES, type ConfiguredSeverity, REPORTER_NAMES, type ReporterName, SEVERITIES } from './names.ts';
export { type ConfigReading, readConfig } from './read-config.ts';

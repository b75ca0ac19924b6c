// The configuration of a folder.

export { ACCURACY_NAMES, type ConfiguredSeverity, REPORTER_NAMES, type ReporterName, SEVERITIES } from '../basics/index.ts';
export { type ConfigFile, configSchema, type SeverityMap } from './config.ts';
export { type ConfigReading, readConfig } from './read-config.ts';

/** The accuracies that a configuration can name. */
export const ACCURACY_NAMES = ['arcade', 'fast', 'standard', 'precise'] as const;

/** The formats of reports that a configuration can name. */
export const REPORTER_NAMES = ['pretty', 'json', 'github', 'junit', 'sarif', 'markdown'] as const;

/** The name of a format of reports. */
export type ReporterName = (typeof REPORTER_NAMES)[number];

/** The severities that a configuration can set. */
export const SEVERITIES = ['error', 'warning', 'off'] as const;

/** A severity that a configuration can set. */
export type ConfiguredSeverity = (typeof SEVERITIES)[number];

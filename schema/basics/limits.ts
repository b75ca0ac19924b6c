/** Limits of the numbers and lists in a level: largest values, and the smallest radius. */
export const LIMITS = {
  /** Coordinates, px, either sign. */
  coordinate: 1e9,
  /** Radii and the range, px. */
  radius: 1e6,
  /**
   * The smallest radius and range, px. Recoil is proportional to 1 / diameter, and only rounding could hit anything smaller.
   */
  leastRadius: 1e-3,
  /** Velocities, px/s per axis, either sign: the game's own speed limit. */
  velocity: 1000,
  /** Ticks of 1/60 s in holds: one hour. */
  tick: 216_000,
  /** Objects in one list. */
  objects: 20_000,
  /** Runs in one level. */
  runs: 1000,
  /** Holds in one run. */
  holds: 20_000,
  /** Notes in one run. */
  notes: 1000,
  /** Characters of a note. */
  note: 200,
  /** Conflicts that a merge may leave in one level. */
  conflicts: 20_000,
  /** Characters of the reason why a problem is allowed. */
  reason: 300,
} as const;

/** The version of the level format that this toolkit writes. */
export const LEVEL_VERSION = 1;

/** The range of a level that does not set one: farther than this from the centre of every asteroid she is lost, px. */
export const DEFAULT_RANGE = 250;

/** s; a run has at least one tick of 1/60 s. */
export const SHORTEST_RUN = 0.01;

/** s; the longest run that is ever simulated: one hour, the limit of holds in a level file. */
export const LONGEST_RUN = 3600;

/** The largest work that may be allowed for a level, pieces of motion: counts must stay exact whole numbers. */
export const MOST_WORK = 1e12;

/** Larger files are not read: bytes, or UTF-16 code units of a text. */
export const MAX_FILE_SIZE = 8 * 1024 * 1024;

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

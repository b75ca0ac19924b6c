/**
 * How motion is advanced between events: in frames as the original game does (`arcade`), by semi-implicit Euler, by velocity
 * Verlet, by 4th-order Runge-Kutta, or by Taylor series with error control.
 */
export type Integrator = 'arcade' | 'euler' | 'verlet' | 'rk4' | 'taylor';

/** When contacts are tested: once per frame, as in the original game (`frame`), or along the whole path (`swept`). */
export type ContactTest = 'frame' | 'swept';

/**
 * A complete description of how a scene is simulated. {@link ACCURACIES} has the named ones; {@link accuracyOf} names a custom
 * setting.
 */
export interface Accuracy {
  /** A key of {@link ACCURACIES}, or a description such as `rk4 120 Hz, frame`. */
  readonly name: string;
  /** How motion is advanced between events. */
  readonly integrator: Integrator;
  /** Steps per second of a fixed-step integrator, Hz; null for one with error control. */
  readonly rate: number | null;
  /** Position error per second that an integrator with error control aims at, px; null for a fixed-step integrator. */
  readonly tolerance: number | null;
  /** When contacts are tested. */
  readonly contact: ContactTest;
}

/** The accuracies that have a name. `arcade` plays the frames of the original game; `precise` is the default. */
export const ACCURACIES = {
  arcade: { name: 'arcade', integrator: 'arcade', rate: 60, tolerance: null, contact: 'frame' },
  fast: { name: 'fast', integrator: 'verlet', rate: 60, tolerance: null, contact: 'swept' },
  standard: { name: 'standard', integrator: 'rk4', rate: 60, tolerance: null, contact: 'swept' },
  precise: { name: 'precise', integrator: 'taylor', rate: null, tolerance: 1e-9, contact: 'swept' },
} as const satisfies Record<string, Accuracy>;

/** The name of an accuracy: `arcade`, `fast`, `standard` or `precise`. */
export type AccuracyName = keyof typeof ACCURACIES;

/** The name of the accuracy that is used when none is given. */
export const DEFAULT_ACCURACY: AccuracyName = 'precise';

/**
 * Tells whether a text is the name of an accuracy.
 *
 * @param name - the text
 * @returns whether {@link ACCURACIES} has an accuracy of this name
 */
export const isAccuracyName = (name: string): name is AccuracyName => Object.hasOwn(ACCURACIES, name);

/** An accuracy without its name. */
export type Setting = Omit<Accuracy, 'name'>;

/** What rate (Hz) and tolerance (px per second) a custom setting may have. Below the least tolerance, only rounding is left. */
export const ACCURACY_LIMITS = { rate: { least: 1, most: 100_000 }, tolerance: { least: 1e-14, most: 1 } } as const;

/** The name of a custom setting, for example `rk4 120 Hz, frame`. Swept contacts are not mentioned. */
function nameOfSetting({ integrator, rate, tolerance, contact }: Setting): string {
  const size = rate === null ? `${tolerance?.toExponential()} px` : `${rate} Hz`;
  return `${integrator} ${size}${contact === 'frame' ? ', frame' : ''}`;
}

const sameSetting = (a: Setting, b: Setting): boolean =>
  a.integrator === b.integrator && a.rate === b.rate && a.tolerance === b.tolerance && a.contact === b.contact;

/**
 * Makes an accuracy of its settings.
 *
 * @param setting - integrator, rate (Hz) or tolerance (px), and contact test
 * @returns the named accuracy with these settings if there is one, otherwise one that is named after its settings
 * @throws {RangeError} when the settings contradict each other, or are not within {@link ACCURACY_LIMITS}
 */
export function accuracyOf(setting: Setting): Accuracy {
  const valid = validSetting(setting);
  return (
    Object.values<Accuracy>(ACCURACIES).find((named) => sameSetting(valid, named)) ?? { name: nameOfSetting(valid), ...valid }
  );
}

const NAMES = Object.keys(ACCURACIES).join(', ');

/** A value in an error; an accuracy may come from code without types. */
function found(value: unknown): string {
  if (value === undefined) return 'nothing';
  return typeof value === 'string'
    ? JSON.stringify(value)
    : typeof value === 'object' && value !== null
      ? 'an object'
      : `${value}`;
}

/**
 * Tests an accuracy that somebody gave: nothing about it may be left to chance, since a run under a malformed one goes anywhere.
 *
 * @param accuracy - a name, or a setting; a rate or tolerance that is left out counts as null, and a name may be missing
 * @returns the accuracy, with every member
 * @throws {RangeError} when it is none: says what was expected and what was found
 */
export function validAccuracy(accuracy: AccuracyName | Accuracy): Accuracy {
  if (typeof accuracy === 'string') {
    if (isAccuracyName(accuracy)) return ACCURACIES[accuracy];
    throw new RangeError(`accuracy: expected ${NAMES}, or a custom setting of accuracyOf, found ${found(accuracy)}`);
  }
  if (typeof accuracy !== 'object' || accuracy === null) {
    throw new RangeError(`accuracy: expected ${NAMES}, or a custom setting of accuracyOf, found ${found(accuracy)}`);
  }
  const { name } = accuracy;
  const known = isAccuracyName(name) ? ACCURACIES[name] : null;
  if (accuracy === known) return known;
  const setting = validSetting(accuracy);
  const isComplete = typeof name === 'string' && accuracy.rate === setting.rate && accuracy.tolerance === setting.tolerance;
  if (isComplete) return known !== null && sameSetting(known, setting) ? known : accuracy;
  return { name: typeof name === 'string' ? name : nameOfSetting(setting), ...setting };
}

/**
 * Tests the members of an accuracy.
 *
 * @param setting - the setting; a rate or tolerance that is left out counts as null
 * @returns the setting without anything else
 * @throws {RangeError} when it is none
 */
function validSetting(setting: Setting): Setting {
  const { integrator, contact } = setting;
  const rate = setting.rate ?? null;
  const tolerance = setting.tolerance ?? null;
  if (!['arcade', 'euler', 'verlet', 'rk4', 'taylor'].includes(integrator)) {
    throw new RangeError(`accuracy, integrator: expected arcade, euler, verlet, rk4 or taylor, found ${found(integrator)}`);
  }
  if (contact !== 'frame' && contact !== 'swept') {
    throw new RangeError(`accuracy, contact: expected "frame" or "swept", found ${found(contact)}`);
  }
  const valid: Setting = { integrator, rate, tolerance, contact };
  if (integrator === 'arcade') {
    const own = ACCURACIES.arcade;
    if (rate === own.rate && tolerance === own.tolerance && contact === own.contact) return valid;
    throw new RangeError(`accuracy: arcade has 60 frames per second and no other setting: expected the name "arcade"`);
  }
  const [size, unit, other] =
    integrator === 'taylor' ? (['tolerance', 'px', 'rate'] as const) : (['rate', 'Hz', 'tolerance'] as const);
  if (valid[other] !== null) {
    const why = integrator === 'taylor' ? 'chooses its own steps' : 'has fixed steps';
    throw new RangeError(
      `accuracy, ${other}: ${integrator} ${why}: expected null, and a ${size} instead, found ${found(valid[other])}`,
    );
  }
  const { least, most } = ACCURACY_LIMITS[size];
  const value: unknown = valid[size];
  if (typeof value === 'number' && value >= least && value <= most) return valid;
  throw new RangeError(`accuracy, ${size}: expected ${least} to ${most} ${unit} for ${integrator}, found ${found(value)}`);
}

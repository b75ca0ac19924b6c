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
export function nameOfSetting({ integrator, rate, tolerance, contact }: Setting): string {
  const size = rate === null ? `${tolerance?.toExponential()} px` : `${rate} Hz`;
  return `${integrator} ${size}${contact === 'frame' ? ', frame' : ''}`;
}

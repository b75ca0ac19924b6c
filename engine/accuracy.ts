/** How motion is advanced between events. */
export type Integrator = 'arcade' | 'euler' | 'verlet' | 'rk4' | 'taylor';

/** When contacts are tested: once a frame, as the original did, or along the whole way. */
export type ContactTest = 'frame' | 'swept';

/** A full description of how a scene is simulated. */
export interface Accuracy {
  readonly name: string;
  readonly integrator: Integrator;
  /** Steps per second of a fixed-step integrator; null for one with error control. */
  readonly rate: number | null;
  /** Position error a second an error-controlled integrator aims at, px; null for a fixed step. */
  readonly tolerance: number | null;
  readonly contact: ContactTest;
}

/** The accuracies that have a name. */
export const ACCURACIES = {
  arcade: { name: 'arcade', integrator: 'arcade', rate: 60, tolerance: null, contact: 'frame' },
  fast: { name: 'fast', integrator: 'verlet', rate: 60, tolerance: null, contact: 'swept' },
  standard: { name: 'standard', integrator: 'rk4', rate: 60, tolerance: null, contact: 'swept' },
  precise: { name: 'precise', integrator: 'taylor', rate: null, tolerance: 1e-9, contact: 'swept' },
} as const satisfies Record<string, Accuracy>;

export type AccuracyName = keyof typeof ACCURACIES;

/** The accuracy used when none is named. */
export const DEFAULT_ACCURACY: AccuracyName = 'precise';

export const isAccuracyName = (name: string): name is AccuracyName => Object.hasOwn(ACCURACIES, name);

/** What a setting is called where it has no name of its own: `rk4 120 Hz, frame`. Swept contacts go without saying. */
function nameOfSetting({ integrator, rate, tolerance, contact }: Omit<Accuracy, 'name'>): string {
  const size = rate === null ? `${tolerance?.toExponential()} px` : `${rate} Hz`;
  return `${integrator} ${size}${contact === 'frame' ? ', frame' : ''}`;
}

const sameSetting = (a: Omit<Accuracy, 'name'>, b: Accuracy): boolean =>
  a.integrator === b.integrator && a.rate === b.rate && a.tolerance === b.tolerance && a.contact === b.contact;

/** The accuracy with these settings: the named one where there is one, else called by its parts. */
export function accuracyOf(setting: Omit<Accuracy, 'name'>): Accuracy {
  const named = Object.values<Accuracy>(ACCURACIES).find((accuracy) => sameSetting(setting, accuracy));
  return named ?? { name: nameOfSetting(setting), ...setting };
}

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

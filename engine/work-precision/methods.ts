import { ACCURACIES, type Accuracy, accuracyOf } from '../accuracy.ts';

/** Steps per second at which fixed-step integrators are measured, Hz. */
export const RATES = [15, 30, 60, 120, 240, 480, 960] as const;

/** Tolerances at which the integrator with error control is measured, px per second; the last is that of `precise`. */
export const TOLERANCES = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9] as const;

/**
 * All settings that are measured: `arcade`, and every integrator at every rate or tolerance, with swept contacts and at frames.
 */
export const METHODS: readonly Accuracy[] = [
  ACCURACIES.arcade,
  ...(['euler', 'verlet', 'rk4'] as const).flatMap((integrator) =>
    (['swept', 'frame'] as const).flatMap((contact) =>
      RATES.map((rate) => accuracyOf({ integrator, rate, tolerance: null, contact })),
    ),
  ),
  ...(['swept', 'frame'] as const).flatMap((contact) =>
    TOLERANCES.map((tolerance) => accuracyOf({ integrator: 'taylor', rate: null, tolerance, contact })),
  ),
];

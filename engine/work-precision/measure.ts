import type { Hold, Level } from '../../schema/basics/index.ts';
import { ACCURACIES, type Accuracy, accuracyOf } from '../accuracy.ts';
import { compile } from '../compile.ts';
import { TICK, TICK_RATE } from '../constants.ts';
import { joinHolds } from '../script.ts';
import { createSimulation } from '../simulate.ts';
import { type Ending, type Outcome, type Simulation, STATE_SIZE } from '../simulation.ts';
import { type Cost, measureCosts, playerOf } from './cost.ts';

/** One point of a work-precision diagram. */
export interface Measured extends Deviation {
  readonly accuracy: Accuracy;
  readonly cost: Cost;
}

export interface WorkPrecision {
  readonly reference: Reference;
  readonly methods: readonly Measured[];
}

interface MeasureOptions {
  /** Simulated time after which a run is a timeout, s. */
  readonly maxTime: number;
  /** A clock, ms; the engine has none. */
  readonly now: () => number;
  /** Approximate time for timing, ms; comparing takes additional time. */
  readonly budget: number;
  /** The settings to measure; {@link METHODS} when left out. */
  readonly methods?: readonly Accuracy[];
}

const SAMPLE = 1;

/** Measures what each setting costs in time and in error, for one list of holds on a level. */
export function measureWorkPrecision(level: Level, holds: readonly Hold[], options: MeasureOptions): WorkPrecision {
  const { now, budget, methods = METHODS } = options;
  const maxTicks = Math.round(options.maxTime * TICK_RATE);
  const reference = referenceOf(level, holds, maxTicks);
  const deviations = methods.map((accuracy) => compareWith(reference, level, holds, accuracy, maxTicks));
  const players = methods.map((accuracy) => playerOf([{ level, holds }], accuracy, maxTicks));
  const costs = measureCosts(players, now, { budget, sample: SAMPLE });
  return { reference, methods: methods.map((accuracy, i) => ({ accuracy, ...deviations[i], cost: costs[i] })) };
}

/** Below this error a setting is as good as exact for a level designer, px: a hundredth of what a screen can show. */
export const GOOD_ENOUGH = 0.01;

/** The cheapest setting with the reference's outcome and an error below {@link GOOD_ENOUGH}; null if there is none. */
export function cheapestGoodEnough(methods: readonly Measured[]): Measured | null {
  let best: Measured | null = null;
  for (const method of methods) {
    if (!method.sameVerdict || method.error >= GOOD_ENOUGH) continue;
    if (best === null || method.cost.minimum < best.cost.minimum) best = method;
  }
  return best;
}

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

/** The run that others are compared with. */
export interface Reference {
  /** Tolerance, px per second: a thousandth of the tightest one that is measured. */
  readonly tolerance: number;
  readonly path: Path;
  readonly outcome: Outcome;
  /** When it ended, s. */
  readonly time: number;
  /**
   * How exactly the reference itself is known, px: its largest distance to the same run at two looser tolerances, which are
   * still tighter than all that are measured. At these tolerances the rounding of doubles remains, magnified by the run. An
   * error below this floor means no more than that.
   */
  readonly floor: number;
}

export const REFERENCE_TOLERANCE = TOLERANCES[TOLERANCES.length - 1] / 1000;

/** Looser tolerances that show how far the reference can be trusted. */
const DOUBTS = [3 * REFERENCE_TOLERANCE, 10 * REFERENCE_TOLERANCE];

const swept = (tolerance: number): Accuracy => ({
  name: 'reference',
  integrator: 'taylor',
  rate: null,
  tolerance,
  contact: 'swept',
});

/** Plays holds at the reference's tolerance and estimates how exact the result is. */
export function referenceOf(level: Level, holds: readonly Hold[], maxTicks: number): Reference {
  const play = (tolerance: number) => pathOf(createSimulation(compile(level, swept(tolerance))), holds, maxTicks);
  const path = play(REFERENCE_TOLERANCE);
  return {
    tolerance: REFERENCE_TOLERANCE,
    path,
    ...endOf(path, maxTicks),
    floor: Math.max(...DOUBTS.map((tolerance) => largestDistance(path, play(tolerance)))),
  };
}

/** How and when a run ended; time in s. */
function endOf(path: Path, maxTicks: number): { outcome: Outcome; time: number } {
  return { outcome: path.ending?.outcome ?? 'timeout', time: path.ending?.time ?? maxTicks * TICK };
}

/** How a run at one setting differs from the reference. */
export interface Deviation {
  /** Largest distance to the reference at the ticks before the earlier of both ends, px. */
  readonly error: number;
  readonly outcome: Outcome;
  /** When the run ended, s. */
  readonly time: number;
  /** Whether the outcome is that of the reference. If it is not, the runs diverge, and the error says little. */
  readonly sameVerdict: boolean;
}

/** Compares a path, from whatever engine, with the reference for the same holds. */
export function deviationOf(path: Path, reference: Reference, maxTicks: number): Deviation {
  const { outcome, time } = endOf(path, maxTicks);
  return {
    error: largestDistance(path, reference.path),
    outcome,
    time,
    sameVerdict: outcome === reference.outcome,
  };
}

/** Plays holds at one setting and compares the run with the reference. */
export function compareWith(
  reference: Reference,
  level: Level,
  holds: readonly Hold[],
  accuracy: Accuracy,
  maxTicks: number,
): Deviation {
  return deviationOf(pathOf(createSimulation(compile(level, accuracy)), holds, maxTicks), reference, maxTicks);
}

/** Her place at every tick of a run, and how the run ended. */
export interface Path {
  /** Number of ticks, 0, 1, ... `count - 1`, all before the end. */
  readonly count: number;
  /** Her places, px. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** How the run ended; null if nothing ended it. */
  readonly ending: Ending | null;
}

/**
 * Plays holds from the start and reads her place at every tick. Nothing is recorded, so even an hour at 960 Hz fits into
 * memory.
 * @param maxTicks - ticks of 1/60 s after which the run is a timeout
 */
export function pathOf(simulation: Simulation, holds: readonly Hold[], maxTicks: number): Path {
  const script = joinHolds(holds);
  const state = new Float64Array(STATE_SIZE);
  const x: number[] = [];
  const y: number[] = [];
  const see = () => {
    simulation.readState(state);
    x.push(state[0]);
    y.push(state[1]);
  };
  simulation.reset();
  see();
  let next = 0;
  for (let tick = 0; tick < maxTicks; tick++) {
    while (next < script.length && script[next][1] <= tick) next++;
    simulation.advance(1, next < script.length && script[next][0] <= tick);
    if (simulation.ending !== null) break;
    see();
  }
  const { ending } = simulation;
  // an end within the last tick that a frame detects late does not count as earlier than that tick
  const count = ending === null ? x.length : Math.min(x.length, Math.max(1, Math.ceil(ending.time * TICK_RATE - 1e-9)));
  return { count, x: Float64Array.from(x), y: Float64Array.from(y), ending };
}

/** The largest distance between two runs at ticks before the earlier of their ends, px. */
export function largestDistance(a: Path, b: Path): number {
  let largest = 0;
  for (let i = 0; i < Math.min(a.count, b.count); i++) {
    const dx = a.x[i] - b.x[i];
    const dy = a.y[i] - b.y[i];
    largest = Math.max(largest, dx * dx + dy * dy);
  }
  return Math.sqrt(largest);
}

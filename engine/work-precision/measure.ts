import type { Hold, Level } from '../../schema/basics/index.ts';
import { ACCURACIES, type Accuracy, accuracyOf } from '../accuracy.ts';
import { compile } from '../compile.ts';
import { TICK, TICK_RATE } from '../constants.ts';
import type { Scene } from '../scene.ts';
import { joinHolds, playScript } from '../script.ts';
import { createSimulation, type Run } from '../simulate.ts';
import { type Ending, type Outcome, type Simulation, STATE_SIZE } from '../simulation.ts';
import { maxTicksOf } from '../terms.ts';
import { WorkBudget, WorkLimitReached } from '../work-budget.ts';
import { type Cost, measureCosts, playerOf } from './cost.ts';
import {
  apart,
  GAUSS_TOLERANCE,
  gauss,
  type Method,
  NotCovered,
  type Played,
  play,
  TAYLOR_TOLERANCE,
  taylor,
  toNumber,
} from './reference/index.ts';

/** One point of a work-precision diagram. */
export interface Measured extends Deviation {
  readonly accuracy: Accuracy;
  readonly cost: Cost;
}

/** How all settings differ from a reference. */
export interface Compared {
  readonly reference: Reference;
  readonly methods: readonly (Deviation & { readonly accuracy: Accuracy })[];
  /** Settings of which not all is known, as their run takes too much work or the time was used up, and until when they played, s. */
  readonly unmeasured: readonly { readonly accuracy: Accuracy; readonly time: number; readonly why: 'work' | 'time' }[];
}

export interface WorkPrecision extends Compared {
  readonly methods: readonly Measured[];
}

interface CompareOptions {
  /** Simulated time after which a run is a timeout, s. */
  readonly maxTime: number;
  /** The most work that a run may cost, pieces of motion. */
  readonly maxWork: number;
  /** The settings to compare. */
  readonly methods: readonly Accuracy[];
  /** A clock, ms; the engine has none. */
  readonly now: () => number;
  /** The longest that is compared, about how long is timed, and the longest, ms; a play that has begun ends. References are apart. */
  readonly budget: { readonly comparing: number; readonly timing: number; readonly most: number };
}

/** Measures what each setting costs in time and in error, for one list of holds on a level. */
export const measureWorkPrecision = (level: Level, holds: readonly Hold[], options: CompareOptions): WorkPrecision =>
  withCosts(level, holds, compareAll(level, holds, options), options);

/** What each setting costs in error. */
export function compareAll(level: Level, holds: readonly Hold[], options: CompareOptions): Compared {
  const maxTicks = maxTicksOf(options);
  const reference = referenceOf(level, holds, maxTicks, options.maxWork);
  const methods: Compared['methods'][number][] = [];
  const unmeasured: Compared['unmeasured'][number][] = [];
  const end = options.now() + options.budget.comparing;
  for (const accuracy of [...options.methods].sort(inHaste)) {
    if (options.now() > end) {
      unmeasured.push({ accuracy, time: 0, why: 'time' });
      continue;
    }
    const simulation = createSimulation(compile(level, accuracy), new WorkBudget(options.maxWork));
    try {
      methods.push({ accuracy, ...deviationOf(pathOf(simulation, holds, maxTicks), reference, maxTicks) });
    } catch (error) {
      if (!(error instanceof WorkLimitReached)) throw error;
      unmeasured.push({ accuracy, time: simulation.tick * TICK, why: 'work' });
    }
  }
  const place = ({ accuracy }: { readonly accuracy: Accuracy }) => options.methods.indexOf(accuracy);
  for (const list of [methods, unmeasured]) list.sort((a, b) => place(a) - place(b));
  return { reference, methods, unmeasured };
}

/** What each setting that was compared costs in time. */
export function withCosts(level: Level, holds: readonly Hold[], compared: Compared, options: CompareOptions): WorkPrecision {
  const inOrder = [...compared.methods].sort((a, b) => inHaste(a.accuracy, b.accuracy));
  const players = inOrder.map(({ accuracy }) => playerOf([{ level, holds }], accuracy, maxTicksOf(options)));
  const { timing, most } = options.budget;
  const costs = measureCosts(players, options.now, { budget: timing, most, sample: 1 });
  const unmeasured = [...compared.unmeasured];
  const methods = compared.methods.flatMap((method): Measured[] => {
    const cost = costs[inOrder.indexOf(method)];
    if (cost === null) unmeasured.push({ accuracy: method.accuracy, time: method.time, why: 'time' });
    return cost === null ? [] : [{ ...method, cost }];
  });
  return { ...compared, methods, unmeasured };
}

const rankOf = (one: Accuracy) => (Object.hasOwn(ACCURACIES, one.name) || !METHODS.includes(one) ? -1 : (one.rate ?? 0));

/** What comes first where the time is short: the named settings, one that was asked for, and the coarsest, which take least. */
export const inHaste = (a: Accuracy, b: Accuracy): number => rankOf(a) - rankOf(b);

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
  /** How it was computed. */
  readonly method: string;
  /** How far a step of it may be from the truth, px. */
  readonly tolerance: number;
  readonly path: Path;
  readonly outcome: Outcome;
  /** When it ended, s. */
  readonly time: number;
  /**
   * How exactly the reference is known, px: the largest distance, at ticks before the end, to a second reference, which computes
   * motion and locates events in another way. An error below this says no more than that. Null where there is none: see `doubt`.
   */
  readonly knownTo: number | null;
  /** Why there are no two references that agree; null if there are. */
  readonly doubt: string | null;
}

const GAUSS = 'Gauss collocation of order 32, events bracketed; 32 digits';
const TAYLOR = 'Taylor series of degree 30, roots of polynomials isolated; 32 digits';

/** Evaluations of a force or a guard after which a reference gives up: a minute of play among many objects takes 40,000. */
const MOST_WORK = 800_000;

/** Pieces of motion of `precise` up to which a run is played with 32 digits; each of them takes such a reference some ms. */
const REFERENCE_WORK = 5000;

/** The tolerance of the run that stands in where the game's rules and 32 digits do not decide, px per second. */
const STAND_IN_TOLERANCE = TOLERANCES[TOLERANCES.length - 1] / 1000;

/**
 * Plays holds by two methods that share neither the integrator nor the location of events with anything that is measured, nor
 * with each other: what they share are the rules of the game and the arithmetic. Where they do not cover a run, a run of the
 * engine itself stands in, and says so.
 * @param maxTicks - ticks of 1/60 s after which the run is a timeout
 * @param maxWork - the most work that a run of the engine that stands in may cost, pieces of motion; the default limit when left out
 * @throws WorkLimitReached when it costs more
 */
export function referenceOf(level: Level, holds: readonly Hold[], maxTicks: number, maxWork?: number): Reference {
  const isLong = !endsWithin(REFERENCE_WORK, level, holds, maxTicks);
  const playBy = (method: Method): Played | string => {
    if (isLong) return `the run takes more than ${REFERENCE_WORK} pieces of motion`;
    try {
      return play(level, holds, { method, maxTicks, every: 1, nudge: [0, 0, 0, 0], mostWork: MOST_WORK });
    } catch (error) {
      if (error instanceof NotCovered) return error.message;
      throw error;
    }
  };
  const first = playBy(gauss);
  const second = playBy(taylor);
  if (typeof first !== 'string') {
    const of = { method: GAUSS, tolerance: GAUSS_TOLERANCE, ...referencePath(first) };
    if (typeof second === 'string') return { ...of, knownTo: null, doubt: `a second reference gives up: ${second}` };
    if (touchedBy(first) !== touchedBy(second)) {
      const doubt = `two references end differently: ${endInWords(first)}, and ${endInWords(second)}`;
      return { ...of, knownTo: null, doubt };
    }
    return { ...of, knownTo: apart(first, second), doubt: null };
  }
  const doubt = `a reference gives up: ${first}`;
  if (typeof second !== 'string')
    return { method: TAYLOR, tolerance: TAYLOR_TOLERANCE, ...referencePath(second), knownTo: null, doubt };
  const accuracy = accuracyOf({ integrator: 'taylor', rate: null, tolerance: STAND_IN_TOLERANCE, contact: 'swept' });
  const path = pathOf(createSimulation(compile(level, accuracy), new WorkBudget(maxWork)), holds, maxTicks);
  return {
    method: `the engine itself, ${accuracy.name}`,
    tolerance: STAND_IN_TOLERANCE,
    path,
    ...endOf(path, maxTicks),
    knownTo: null,
    doubt: `no reference covers this run: ${first}`,
  };
}

/** Whether a run at `precise` costs no more than so much work, pieces of motion. */
function endsWithin(work: number, level: Level, holds: readonly Hold[], maxTicks: number): boolean {
  try {
    playScript(createSimulation(compile(level), new WorkBudget(work)), joinHolds(holds), maxTicks);
    return true;
  } catch (error) {
    if (error instanceof WorkLimitReached) return false;
    throw error;
  }
}

function referencePath(played: Played): Pick<Reference, 'path' | 'outcome' | 'time'> {
  const { samples, end, outcome } = played;
  const time = toNumber(end.time);
  const ending = outcome === 'timeout' ? null : { outcome, with: played.with, time, tick: Math.floor(time * TICK_RATE) };
  const path = {
    count: samples.length,
    x: Float64Array.from(samples, ({ at }) => toNumber(at.x)),
    y: Float64Array.from(samples, ({ at }) => toNumber(at.y)),
    ending,
  };
  return { path, outcome, time };
}

const touchedBy = ({ outcome, with: touched }: Played): string => `${outcome} ${touched?.kind} ${touched?.index}`;

const endInWords = ({ outcome, end }: Played): string => `${outcome} at ${toNumber(end.time).toFixed(6)} s`;

/** How and when a run ended; time in s. */
function endOf(path: Path, maxTicks: number): { outcome: Outcome; time: number } {
  return { outcome: path.ending?.outcome ?? 'timeout', time: path.ending?.time ?? maxTicks * TICK };
}

/** How a run at one setting differs from the reference. */
export interface Deviation {
  /** Largest distance to the reference at the ticks before the earlier of both ends, px. */
  readonly error: number;
  readonly outcome: Outcome;
  /** What she touched; null when there is nothing. */
  readonly with: Ending['with'];
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
    with: path.ending?.with ?? null,
    time,
    sameVerdict: outcome === reference.outcome,
  };
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

/** The same of a run that was recorded, up to rounding: nothing is played again. */
export function pathOfRun({ trajectory, outcome, with: touched, time, tick }: Run, scene: Scene): Path {
  const ending = outcome === 'timeout' ? null : { outcome, with: touched, time, tick };
  const count = ending === null ? tick + 1 : Math.max(1, Math.ceil(time * TICK_RATE - 1e-9));
  // recordings of frames begin with the state after the first one
  const ahead = scene.accuracy.integrator === 'arcade' ? 1 : 0;
  const [x, y] = [new Float64Array(count), new Float64Array(count)];
  const state = new Float64Array(STATE_SIZE);
  for (let at = ahead; at < count; at++) {
    trajectory.at((at - ahead) * TICK, state);
    [x[at], y[at]] = [state[0], state[1]];
  }
  if (ahead === 1) [x[0], y[0]] = [scene.level.astronaut.x, scene.level.astronaut.y];
  return { count, x, y, ending };
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

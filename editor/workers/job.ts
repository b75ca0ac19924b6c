import {
  type AccuracyName,
  createSimulation,
  isAccuracyName,
  joinHolds,
  playScript,
  type Scene,
  STATE_SIZE,
  type Terms,
} from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';

/** What the page has to know of a job, and the types of what it is asked, reports and answers. */
export interface Job<Q = unknown, A = unknown, P = unknown> {
  readonly name: string;
  /**
   * `quick`: it follows every change and is over soon, and waits for others like it alone. `long`: it has a worker of its own while
   * it runs, so that it neither waits nor delays anything.
   */
  readonly lane: 'quick' | 'long';
  /** ms after which it is stopped, as a level can be made to take hours; null: it has a limit of its own, or runs until it is cancelled. */
  readonly most: number | null;
  /** Only for the compiler. */
  readonly types?: { readonly asked: Q; readonly answer: A; readonly progress: P };
}

export type AskedOf<J extends Job> = NonNullable<J['types']>['asked'];
export type AnswerOf<J extends Job> = NonNullable<J['types']>['answer'];
export type ProgressOf<J extends Job> = NonNullable<J['types']>['progress'];

/** A job that is asked `Q` and answers `A`; on the way it reports `P`. */
export const job = <Q, A, P = never>(record: Pick<Job, 'name' | 'lane' | 'most'>): Job<Q, A, P> => record;

/**
 * A job in slices: each step should take only a few ms, and yields a report or null. A part that can't be divided is one long
 * step; cancelling it ends the worker.
 */
export type Steps<J extends Job> = Generator<ProgressOf<J> | null, AnswerOf<J>, void>;

/** How a worker does a job. It is a value of its own, so that the page does not have to load it. */
export interface Work<J extends Job> {
  readonly of: J;
  /** Begins it. @param now a clock, ms */
  steps(asked: AskedOf<J>, now: () => number): Steps<J>;
}

/** A level to simulate in a job. */
export interface Played {
  readonly level: Level;
  /** Under which the answer has to hold. */
  readonly terms: Terms;
}

/** The name of the accuracy: the page knows no custom settings. */
export function accuracyNameOf({ accuracy: { name } }: Pick<Terms, 'accuracy'>): AccuracyName {
  if (!isAccuracyName(name)) throw new Error(`expected a named accuracy, found ${name}`);
  return name;
}

/** target duration of a step in ms: a cancel is not received within a step */
const STEP = 12;
const FEWEST_TICKS = 500;
const MOST_TICKS = 2_000_000;

/** Advances something by as many ticks as take about one step; it learns that number. */
export function createPacer(now: () => number): (advance: (ticks: number) => void) => void {
  let ticks = 5000;
  return (advance) => {
    const start = now();
    advance(ticks);
    const took = now() - start;
    const factor = took > 0 ? STEP / took : 2;
    ticks = Math.round(Math.min(MOST_TICKS, Math.max(FEWEST_TICKS, ticks * Math.min(2, Math.max(0.25, factor)))));
  };
}

/**
 * Paces reports.
 * @param start when the job began, by the same clock
 * @returns whether a report is due: at news, and otherwise `ms` after the last one
 */
export function createReporting(ms: number, start: number, now: () => number): (isNews?: boolean) => boolean {
  let last = start;
  return (isNews = false) => {
    const isDue = isNews || now() - last >= ms;
    if (isDue) last = now();
    return isDue;
  };
}

/** ticks per step */
const TICKS = 20;

/** Her way, an entry for every tick and one for the end. */
export interface Followed {
  /** x, y in px */
  readonly points: Float32Array;
  /** The direction of the box's x axis: cos, sin. */
  readonly turns: Float32Array;
}

/** Follows her tick by tick, in steps. @param until the last tick */
export function* follow(scene: Scene, holds: readonly Hold[], until: number): Generator<null, Followed, void> {
  const simulation = createSimulation(scene);
  const script = joinHolds(holds);
  const state = new Float64Array(STATE_SIZE);
  const points: number[] = [];
  const turns: number[] = [];
  for (;;) {
    simulation.readState(state);
    points.push(state[0], state[1]);
    turns.push(state[4], state[5]);
    const { tick } = simulation;
    if (simulation.ending !== null || tick >= until) break;
    playScript(simulation, script, tick + 1);
    if (tick % TICKS === 0) yield null;
  }
  return { points: Float32Array.from(points), turns: Float32Array.from(turns) };
}

import type { Hold } from '../schema/basics/index.ts';
import { ArcadeSimulation, FrameRecorder } from './arcade/index.ts';
import type { Clearance } from './clearance.ts';
import { TICK, TICK_RATE } from './constants.ts';
import { ContinuousSimulation, EventRecorder, PieceRecorder, WHOLE_METHOD } from './continuous/index.ts';
import { Hash } from './hash.ts';
import type { Scene } from './scene.ts';
import { joinHolds, playScript } from './script.ts';
import {
  type Mode,
  type Outcome,
  type RunEvent,
  type Simulation,
  STATE_SIZE,
  type Touched,
  type Trajectory,
  type Work,
} from './simulation.ts';
import { maxTicksOf } from './terms.ts';
import { unlimited, type WorkBudget, WorkLimitReached } from './work-budget.ts';

/** The state of the astronaut at one moment. */
export interface State {
  /** x of her centre, px. */
  readonly x: number;
  /** y of her centre, px, downwards. */
  readonly y: number;
  /** Velocity to the right, px/s. */
  readonly vx: number;
  /** Velocity downwards, px/s. */
  readonly vy: number;
  /** x of the direction of the collision box's x axis, a unit vector. */
  readonly cos: number;
  /** y of that direction. */
  readonly sin: number;
}

/**
 * A complete run, as {@link simulate} gives it. `clearance`, `trajectory` and `hash` are getters: a copy made with `{ ...run }` has
 * none of them.
 */
export interface Run {
  /** How the run ended. */
  readonly outcome: Outcome;
  /** The object she touched; null after `lost` and `timeout`. */
  readonly with: Touched | null;
  /** When the run ended, s from the start. */
  readonly time: number;
  /** The 1/60 s tick that `time` falls in; under `arcade` the frame whose update raised the outcome. */
  readonly tick: number;
  /** The minerals she collected, in that order. `arcade` may count one twice, as the original game did. */
  readonly minerals: readonly {
    /** Index within the level's minerals, from 0. */
    readonly index: number;
    /** When she collected it, s from the start. */
    readonly time: number;
  }[];
  /** Everything that happened, in order of time. */
  readonly events: readonly RunEvent[];
  /** The least distance to a hazard; null if the level has none. Computed when first read. */
  readonly clearance: Clearance | null;
  /** Her state at the end. */
  readonly final: State;
  /** The motion of the whole run. */
  readonly trajectory: Trajectory;
  /** What the run cost. */
  readonly work: Work;
  /** Share of the simulated time in each mode of motion. */
  readonly modes: readonly Mode[];
  /**
   * A checksum, 16 hexadecimal digits, of the state at every tick, every event and the final state, bit for bit. It is the same
   * in every JavaScript engine. Computed when first read.
   */
  readonly hash: string;
  /**
   * `work-limit` if the run's budget was used up before the run ended, otherwise null. In that case `outcome` is `timeout` and
   * only says that the run had not ended by `time`.
   */
  readonly stopped: 'work-limit' | null;
}

/** Options of {@link simulate}. */
export interface SimulateOptions {
  /** Simulated time after which the run ends as a `timeout`, s; that of the scene's terms when left out. Rounded to ticks. */
  readonly maxTime?: number;
  /**
   * Limits the work of the run, of its recording, and of reading `clearance`, `hash` and `trajectory`; no limit when left out.
   * Reading one of these throws {@link WorkLimitReached} when less is left than it takes.
   */
  readonly budget?: WorkBudget;
  /**
   * Whether the path is kept; true when left out. With false only events are kept, and `clearance`, `hash` and `trajectory`
   * each play the run again when they are read. Use it for many runs of which few are examined.
   */
  readonly record?: boolean;
}

/**
 * Creates a simulation at the start of a scene, which the caller advances: for a playtest or a search.
 *
 * @param scene - the scene
 * @param budget - limits the work of the simulation; no limit when left out
 * @param events - receives what happens, in order of time; the caller may empty it. When left out, events are not made
 * @returns the simulation
 *
 * @example
 * ```ts
 * const simulation = createSimulation(compile(level));
 * simulation.advance(12, false);
 * const before = simulation.snapshot();
 * simulation.advance(84, true);
 * if (simulation.ending?.outcome !== 'completed') simulation.restore(before);
 * ```
 */
export function createSimulation(scene: Scene, budget: WorkBudget = unlimited(), events: RunEvent[] | null = null): Simulation {
  if (scene.accuracy.integrator === 'arcade') {
    return new ArcadeSimulation(scene, events === null ? null : new FrameRecorder(scene, budget, false, events), budget);
  }
  return new ContinuousSimulation(WHOLE_METHOD, scene, events === null ? null : new EventRecorder(events), budget);
}

/**
 * Plays holds from the start of a scene and reports the run in full. A budget that is used up during the run does not throw;
 * see {@link Run.stopped}.
 *
 * @param scene - the scene
 * @param holds - half-open intervals [press, release) in ticks of 1/60 s; overlapping ones are joined
 * @param options - time limit, budget and recording
 * @returns the run
 *
 * @example
 * ```ts
 * const run = simulate(compile(level), [[12, 96], [130, 188]]);
 * console.log(run.outcome, run.time, run.minerals.length);
 * ```
 */
export function simulate(scene: Scene, holds: readonly Hold[], options: SimulateOptions = {}): Run {
  const maxTicks = maxTicksOf({ maxTime: options.maxTime ?? scene.terms.maxTime });
  const budget = options.budget ?? unlimited();
  const keeps = options.record ?? true;
  const played = play(scene, joinHolds(holds), maxTicks, budget, keeps);
  const again = keeps ? null : (): Run => budget.lend(() => simulate(scene, holds, { ...options, record: true }));
  return new SimulatedRun(played, maxTicks, budget, again);
}

/**
 * A run whose costly parts are computed on demand. It is a class because V8 makes a hidden class of its own for each object
 * literal with getters; these live long, and keep the whole run and its scene in memory until the next full collection.
 */
class SimulatedRun implements Run {
  readonly outcome: Outcome;
  readonly with: Touched | null;
  readonly time: number;
  readonly tick: number;
  readonly minerals: Run['minerals'];
  readonly events: readonly RunEvent[];
  readonly final: State;
  readonly work: Work;
  readonly modes: readonly Mode[];
  readonly stopped: Run['stopped'];
  // hidden from whoever copies, compares or prints a run
  readonly #recorder: Played['recorder'];
  readonly #end = new Float64Array(STATE_SIZE);
  readonly #budget: WorkBudget;
  readonly #again: (() => Run) | null;
  #clearance: Clearance | null | undefined;
  #hash: string | undefined;

  /** @param again - plays the run again with a recording; null if it has one */
  constructor({ recorder, simulation, stopped }: Played, maxTicks: number, budget: WorkBudget, again: (() => Run) | null) {
    const limitTick = stopped === null ? maxTicks : simulation.tick;
    const { ending } = simulation;
    const { events } = recorder;
    const end = this.#end;
    simulation.readState(end);
    this.outcome = ending?.outcome ?? 'timeout';
    this.with = ending?.with ?? null;
    this.time = ending?.time ?? limitTick * TICK;
    this.tick = ending?.tick ?? limitTick;
    this.minerals = events.flatMap((e) => (e.type === 'mineral' ? [{ index: e.index, time: e.time }] : []));
    this.events = events;
    this.final = { x: end[0], y: end[1], vx: end[2], vy: end[3], cos: end[4], sin: end[5] };
    // the simulation goes on to read the recording
    const { pieces, forceEvaluations, guards, roots } = simulation.work;
    this.work = { pieces, forceEvaluations, guards, roots };
    this.modes = simulation.modes;
    this.stopped = stopped;
    if (recorder instanceof PieceRecorder && simulation instanceof ContinuousSimulation) recorder.readWith(simulation);
    this.#recorder = recorder;
    this.#budget = budget;
    this.#again = again;
  }

  get clearance(): Clearance | null {
    if (this.#clearance === undefined) {
      this.#clearance = this.#again === null ? this.#recorder.clearance() : this.#again().clearance;
    }
    return this.#clearance;
  }

  get trajectory(): Trajectory {
    return this.#again === null ? this.#recorder : this.#again().trajectory;
  }

  get hash(): string {
    this.#hash ??=
      this.#again === null ? hashRun(this.#recorder, this.events, this.#end, this.outcome, this.#budget) : this.#again().hash;
    return this.#hash;
  }
}

interface Played {
  readonly recorder: PieceRecorder | FrameRecorder;
  readonly simulation: Simulation;
  readonly stopped: Run['stopped'];
}

function play(scene: Scene, holds: readonly Hold[], maxTicks: number, budget: WorkBudget, keeps: boolean): Played {
  const { recorder, simulation } = recorded(scene, budget, keeps);
  try {
    playScript(simulation, holds, maxTicks);
    if (simulation instanceof ContinuousSimulation) simulation.recordLast();
    return { recorder, simulation, stopped: null };
  } catch (error) {
    if (!(error instanceof WorkLimitReached)) throw error;
    return { recorder, simulation, stopped: 'work-limit' };
  }
}

function recorded(scene: Scene, budget: WorkBudget, keeps: boolean) {
  if (scene.accuracy.integrator === 'arcade') {
    const recorder = new FrameRecorder(scene, budget, keeps);
    return { recorder, simulation: new ArcadeSimulation(scene, recorder, budget) };
  }
  const recorder = new PieceRecorder(scene, budget, keeps);
  return { recorder, simulation: new ContinuousSimulation(WHOLE_METHOD, scene, recorder, budget) };
}

function hashRun(
  trajectory: Trajectory,
  events: readonly RunEvent[],
  final: Float64Array,
  outcome: Outcome,
  budget: WorkBudget,
): string {
  const hash = new Hash();
  const state = new Float64Array(STATE_SIZE);
  const ticks = Math.floor(trajectory.duration * TICK_RATE + 1e-6);
  for (let tick = 0; tick <= ticks; tick++) {
    budget.look(4);
    trajectory.at(tick * TICK, state);
    for (let i = 0; i < STATE_SIZE; i++) hash.add(state[i]);
  }
  for (const event of events) hash.addEvent(event);
  hash.addText(outcome);
  for (let i = 0; i < STATE_SIZE; i++) hash.add(final[i]);
  return hash.digest();
}

import type { Hold } from '../schema/index.ts';
import { ArcadeSimulation, FrameRecorder } from './arcade/index.ts';
import type { Clearance } from './clearance.ts';
import { DEFAULT_MAX_TIME, TICK, TICK_RATE } from './constants.ts';
import { ContinuousSimulation, PieceRecorder } from './continuous/index.ts';
import { Hash } from './hash.ts';
import type { Scene } from './scene.ts';
import { joinHolds, playScript } from './script.ts';
import { type Mode, type Outcome, type RunEvent, type Simulation, STATE_SIZE, type Touched, type Work } from './simulation.ts';
import type { Trajectory } from './trajectory.ts';
import { unlimited, type WorkBudget, WorkLimitReached } from './work-budget.ts';

/** x, y in px, vx, vy in px/s; cos, sin: direction of the box's x axis, a unit vector. */
export interface State {
  readonly x: number;
  readonly y: number;
  readonly vx: number;
  readonly vy: number;
  readonly cos: number;
  readonly sin: number;
}

export interface Run {
  readonly outcome: Outcome;
  readonly with: Touched | null;
  /** s from the start */
  readonly time: number;
  /** The 1/60 s tick that `time` falls in; under `arcade` the frame whose update raised the outcome. */
  readonly tick: number;
  /** In the order they were collected. `arcade` may count one twice, as the original did. */
  readonly minerals: readonly { readonly index: number; readonly time: number }[];
  readonly events: readonly RunEvent[];
  /** null where the level has nothing deadly */
  readonly clearance: Clearance | null;
  readonly final: State;
  readonly trajectory: Trajectory;
  readonly work: Work;
  /** Share of the simulated time in each mode of motion. */
  readonly modes: readonly Mode[];
  /** Over the state at every tick, every event and the final state, bit for bit; the same in every JavaScript engine. */
  readonly hash: string;
  /**
   * The limit that ended the run before its time, or null. `work-limit`: the budget it was given is used up; how it would go on is
   * not known, and `outcome` says no more than that it had not ended by `time`.
   */
  readonly stopped: 'work-limit' | null;
}

export interface SimulateOptions {
  /** s of simulated time after which the run is a `timeout`; {@link DEFAULT_MAX_TIME} when left out */
  readonly maxTime?: number;
  /**
   * What the run may cost, its recording and what is later asked of that; no limit when left out. Asked for more than is left, its
   * clearance, hash and trajectory throw a WorkLimitReached.
   */
  readonly budget?: WorkBudget;
  /**
   * false: nothing but events is kept. Clearance, hash and trajectory are there all the same: the run is played again for each, so take
   * them once. For many runs of which few are looked at.
   */
  readonly record?: boolean;
}

/**
 * A simulation at the start of the scene, to be advanced by hand: a playtest, a search.
 * @param budget what it may cost; advanced when that is used up, it throws a WorkLimitReached. No limit when left out
 */
export function createSimulation(scene: Scene, budget: WorkBudget = unlimited()): Simulation {
  return scene.accuracy.integrator === 'arcade'
    ? new ArcadeSimulation(scene, null, budget)
    : new ContinuousSimulation(scene, null, budget);
}

/**
 * Plays a script and says in full what happened.
 * @param holds half-open [press, release) intervals in ticks of 1/60 s; overlapping ones are joined
 */
export function simulate(scene: Scene, holds: readonly Hold[], options: SimulateOptions = {}): Run {
  const maxTicks = Math.round((options.maxTime ?? DEFAULT_MAX_TIME) * TICK_RATE);
  const budget = options.budget ?? unlimited();
  const { recorder, simulation, stopped } = play(scene, joinHolds(holds), maxTicks, budget, options.record ?? true);
  const limitTick = stopped === null ? maxTicks : simulation.tick;

  const ending = simulation.ending;
  const outcome = ending?.outcome ?? 'timeout';
  const { events } = recorder;
  const state = new Float64Array(STATE_SIZE);
  simulation.readState(state);
  // looked at by some, and dearer than the run itself: made when asked for
  let clearance: Clearance | null | undefined;
  let hash: string | undefined;
  const again = (): Run => budget.lend(() => simulate(scene, holds, { ...options, record: true }));
  const isKept = options.record ?? true;
  return {
    outcome,
    with: ending?.with ?? null,
    time: ending?.time ?? limitTick * TICK,
    tick: ending?.tick ?? limitTick,
    minerals: events.flatMap((e) => (e.type === 'mineral' ? [{ index: e.index, time: e.time }] : [])),
    events,
    get clearance() {
      if (clearance === undefined) clearance = isKept ? recorder.clearance() : again().clearance;
      return clearance;
    },
    final: { x: state[0], y: state[1], vx: state[2], vy: state[3], cos: state[4], sin: state[5] },
    get trajectory() {
      return isKept ? recorder : again().trajectory;
    },
    work: simulation.work,
    modes: simulation.modes,
    get hash() {
      if (hash === undefined) hash = isKept ? hashRun(recorder, events, state, outcome, budget) : again().hash;
      return hash;
    },
    stopped,
  };
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
  return { recorder, simulation: new ContinuousSimulation(scene, recorder, budget) };
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
  for (const event of events) {
    hash.addText(event.type);
    if (event.type === 'effect') hash.addText(`${event.effect} ${event.what}`);
    hash.add(event.time);
    if ('index' in event) hash.add(event.index);
    if ('aliens' in event) for (const alien of event.aliens) hash.add(alien);
    if ('with' in event && event.with !== null) {
      hash.addText(event.with.kind);
      hash.add(event.with.index);
    }
  }
  hash.addText(outcome);
  for (let i = 0; i < STATE_SIZE; i++) hash.add(final[i]);
  return hash.digest();
}

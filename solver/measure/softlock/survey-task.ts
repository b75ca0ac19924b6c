import {
  createSimulation,
  joinHolds,
  playScript,
  type Scene,
  type Simulation,
  STATE_SIZE,
  TICK_RATE,
} from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Proof } from '../../prove/index.ts';
import { createSearch, type Moment } from '../../search/explore/index.ts';
import type { Steps } from '../../steps.ts';
import { createReplay } from '../../verified-run.ts';
import { Losses } from './losses.ts';
import { createLongProof, proveLost } from './prove-lost.ts';
import { commonTicks, continued, type Examined, leadsThrough, type Standing, upTo } from './state.ts';

/** Ticks of a search between two breaks. */
const SLICE = 2000;

/** So many of the most similar open states show how to go on, px and px/s. */
const MOST_SIMILAR = 6;
/** Shifts of how they went on, ticks. */
const SHIFTS = [0, -2, 2, -5, 5, -10, 10];
/** A run that is not over this many ticks after its last release is given up. */
const WAIT = 900;

interface Wanted {
  readonly runs: readonly (readonly Hold[])[];
  readonly seed: number;
  readonly maxTicks: number;
}

/** What all parts of a survey share: the states and what is known of each, the runs that complete the level, the work done. */
export class SurveyTask {
  readonly scene: Scene;
  readonly runs: readonly (readonly Hold[])[];
  readonly maxTicks: number;
  readonly states: Examined[] = [];
  /** The moments at which it was lost. */
  readonly losses = new Losses();
  ticks = 0;
  /** What the next step may take, ticks: it is made once so much more work is asked for. */
  reserved = 0;
  runCount = 0;
  private readonly seed: number;
  private readonly simulation: Simulation;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly completing: (readonly Hold[])[] = [];
  private readonly proved: (Moment & { readonly proof: Proof })[] = [];
  private searches = 0;

  constructor(scene: Scene, { runs, seed, maxTicks }: Wanted) {
    this.scene = scene;
    this.runs = runs.map(joinHolds);
    this.seed = seed;
    this.maxTicks = maxTicks;
    this.simulation = createSimulation(scene);
  }

  /** The seed of the next search. */
  nextSeed(): number {
    return this.seed * 65_536 + this.searches++;
  }

  /**
   * Makes a state of a moment.
   * @returns null if the run is over there
   */
  stateAt({ holds, tick }: Moment, run: number | null): Examined | null {
    const cut = upTo(holds, tick);
    this.goTo({ holds: cut, tick });
    if (this.simulation.ending !== null) return null;
    this.simulation.readState(this.state);
    const [x, y, vx, vy] = this.state;
    const onward = this.completing.find((other) => leadsThrough(other, cut, tick)) ?? null;
    const standing: Standing = { is: onward === null ? 'unknown' : 'open' };
    return {
      holds: cut,
      tick,
      x,
      y,
      vx,
      vy,
      standing,
      alive: 0,
      run,
      onward,
      sought: new Set(),
      proving: undefined,
      isKnownTried: false,
    };
  }

  /** Notes a run that completes the level: all states on it are open. */
  complete(holds: readonly Hold[]): void {
    this.completing.push(holds);
    for (const state of this.states) {
      if (!leadsThrough(holds, state.holds, state.tick)) continue;
      state.standing = { is: 'open' };
      state.onward ??= holds;
    }
  }

  /** Searches for a run that completes the level from a state, and notes what comes of it. */
  *searchFrom(state: Examined, ticks: number): Steps<void> {
    if (state.standing.is === 'open' || state.standing.is === 'proved') return;
    const { scene } = this;
    // how late it is already must not count: she has as long from here as from the start
    const maxTicks = state.tick + this.maxTicks;
    const known = yield* this.tryKnown(state, maxTicks);
    if (known !== null) {
      state.standing = { is: 'open' };
      state.onward = known;
      this.complete(known);
      return;
    }
    const search = createSearch(scene, { seed: this.nextSeed(), maxTicks, after: state });
    const before = this.ticks + state.tick;
    this.ticks = before;
    while (search.solutions.length === 0 && search.effort.ticks < ticks && !search.exhausted) {
      search.advance(SLICE);
      this.ticks = before + search.effort.ticks;
      yield null;
    }
    this.runCount += search.effort.runs;
    state.alive = Math.max(state.alive, search.latest - state.tick);
    const solution = search.solutions[0];
    if (solution !== undefined) {
      state.standing = { is: 'open' };
      state.onward = solution.holds;
      this.complete(solution.holds);
    } else {
      // a state on a run that was found meanwhile stays open
      const searched = state.standing.is === 'not found' ? state.standing.ticks : 0;
      state.standing = { is: 'not found', ticks: searched + search.effort.ticks };
    }
  }

  /**
   * Tries how runs went on that complete the level from similar states, with slightly shifted presses and releases.
   * @returns the holds of a run that completes the level from this state, or null
   */
  private *tryKnown(state: Examined, maxTicks: number): Steps<readonly Hold[] | null> {
    if (state.isKnownTried) return null;
    state.isKnownTried = true;
    for (const { onward, tick } of this.similarTo(state)) {
      if (onward === null) continue;
      for (const shift of SHIFTS) {
        const holds = continued(state, onward, tick, shift);
        const replay = createReplay(this.scene, { minerals: 'any' }, maxTicks);
        const run = replay.play(holds, (holds.at(-1)?.[1] ?? state.tick) + WAIT);
        this.ticks += replay.ticks;
        this.runCount++;
        yield null;
        if (run !== null && run.tick >= state.tick) return run.holds;
      }
    }
    return null;
  }

  /** The open states with the most similar place and velocity. */
  private similarTo(state: Examined): Examined[] {
    const square = (a: number, b: number) => (a - b) * (a - b);
    const difference = (other: Examined) =>
      square(other.x, state.x) + square(other.y, state.y) + square(other.vx, state.vx) + square(other.vy, state.vy);
    return this.states
      .filter(({ onward }) => onward !== null)
      .map((other) => ({ other, by: difference(other) }))
      .sort((a, b) => a.by - b.by)
      .slice(0, MOST_SIMILAR)
      .map(({ other }) => other);
  }

  /** Tries once to prove that a state is lost. */
  *prove(state: Examined, by = proveLost): Steps<void> {
    if (state.sought.has(by) || state.standing.is === 'open' || state.standing.is === 'proved') return;
    state.sought.add(by);
    if (this.followsProof(state)) return;
    this.goTo(state);
    const { proof, ticks } = by(this.simulation, this.maxTicks, state.alive);
    this.ticks += ticks;
    if (proof !== null) this.noteProof(state, proof);
    yield null;
  }

  /**
   * Makes the next attempt to prove a state lost with finer sets.
   * @param most attempts that may take more than this are left for later, ticks
   * @returns whether an attempt was made
   */
  *proveLonger(state: Examined, most: number): Steps<boolean> {
    if (state.standing.is !== 'not found' || this.followsProof(state)) return false;
    if (state.proving === undefined) {
      this.goTo(state);
      state.proving = createLongProof(this.simulation, this.maxTicks, state.alive);
    }
    const { proving } = state;
    if (proving === null || proving.finished || proving.nextLimit > most) return false;
    this.reserved = proving.nextLimit;
    yield null;
    this.reserved = 0;
    const before = proving.ticks;
    proving.attempt();
    this.ticks += proving.ticks - before;
    if (proving.proof !== null) this.noteProof(state, proving.proof);
    yield null;
    return true;
  }

  /** Notes that a state comes after one that is proved lost, if it does. */
  private followsProof(state: Examined): boolean {
    const before = this.proved.find(({ holds, tick }) => tick <= state.tick && leadsThrough(state.holds, holds, tick));
    if (before !== undefined) state.standing = { is: 'proved', proof: before.proof };
    return before !== undefined;
  }

  private noteProof(state: Examined, proof: Proof): void {
    state.standing = { is: 'proved', proof };
    this.proved.push({ holds: state.holds, tick: state.tick, proof });
  }

  /** The latest tick on the way to a state at which the black hole is known to be in reach; null if none is known. */
  lastOpen({ holds, tick }: Moment): number | null {
    const common = this.completing.map((other) => commonTicks(other, holds, tick));
    return common.length === 0 ? null : Math.max(...common);
  }

  /** Plays holds to their end. @returns how the run ends, and the last tick at which she is alive */
  playOut(holds: readonly Hold[]): { readonly completes: boolean; readonly last: number } {
    this.goTo({ holds, tick: this.maxTicks });
    const { ending, tick } = this.simulation;
    return {
      completes: ending?.outcome === 'completed',
      last: ending === null ? tick : Math.max(0, Math.ceil(ending.time * TICK_RATE) - 1),
    };
  }

  private goTo({ holds, tick }: Moment): void {
    this.simulation.reset();
    playScript(this.simulation, holds, tick);
    this.ticks += this.simulation.tick;
  }
}

import { firstDifference } from '../../../check/runs/index.ts';
import {
  createSimulation,
  type Ending,
  type Scene,
  type Simulation,
  STATE_SIZE,
  unlimited,
  type WorkBudget,
  WorkLimitReached,
} from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { Tracks } from './tracks.ts';

/**
 * Her states at every tick of a run. The arrays are overwritten by the next run: copy what must be kept. Entry k stands for the
 * time k / 60 s; `count` entries are filled.
 */
export interface Way {
  readonly count: number;
  /** x, y (px), vx, vy (px/s), cos, sin of the box's x axis: `STATE_SIZE` doubles per entry. */
  readonly states: Float64Array;
  /** 1 if the gun is held in the tick that begins with this entry. */
  readonly held: Uint8Array;
  /** x, y, alive of every alien. */
  readonly aliens: Tracks;
  /** x, y of every asteroid in the level's order; none if recoil is off, as they stay in place. */
  readonly asteroids: Tracks;
  /** Her state at the end of the run, which is usually between two ticks; as in `states`. */
  readonly last: Float64Array;
}

/** Her path, copied: x, y in px at every tick and at the end. The arrays of a way are overwritten by the next one. */
export function pathOf({ states, count, last }: Way): Float32Array {
  const points = new Float32Array(2 * count + 2);
  for (let k = 0; k < count; k++) points.set(states.subarray(STATE_SIZE * k, STATE_SIZE * k + 2), 2 * k);
  points.set(last.subarray(0, 2), 2 * count);
  return points;
}

/** The result of a run. */
export interface RecordedRun {
  readonly way: Way;
  /** Whether it was stopped before the end. */
  readonly isCut: boolean;
  /** null: nothing ended it within the time limit */
  readonly ending: Ending | null;
  /** Indices of the collected minerals in order of collection; those of one tick in the level's order. */
  readonly minerals: readonly { readonly index: number; readonly tick: number }[];
  /** The tick from which on it was simulated; earlier ticks were known from the last run. */
  readonly resumedFrom: number;
}

/** ticks between snapshots; on average, half of them are simulated again */
const SNAPSHOT_TICKS = 60;

/**
 * Simulates scripts of holds in one scene tick by tick and records the trajectory. A script that begins like the previous one
 * continues from where they differ, with the same bits as from the start.
 */
export class RunRecorder {
  private readonly simulation: Simulation;
  /** With `arcade`, the entry for time 0 is the state after the first frame, as in its recordings. */
  private readonly ahead: number;
  private readonly last = new Float64Array(STATE_SIZE);
  private readonly state = new Float64Array(STATE_SIZE);
  private minerals: { index: number; tick: number }[] = [];
  private readonly collected: Uint8Array;
  private played: readonly Hold[] | null = null;
  /** The number of the room's snapshots that belong to the current script. */
  private kept = 0;
  private count = 0;
  private ticks = 0;

  /**
   * @param room must not be used by another recorder from now on
   * @param budget limits the work; a run that uses it up is cut
   * @throws WorkLimitReached if it is too small for the start
   */
  constructor(
    readonly scene: Scene,
    readonly maxTicks: number,
    private readonly room = new RecorderRoom(),
    budget: WorkBudget = unlimited(),
  ) {
    this.simulation = createSimulation(scene, budget);
    this.ahead = scene.accuracy.integrator === 'arcade' ? 1 : 0;
    this.collected = new Uint8Array(scene.minerals.count);
    room.prepare(scene.aliens.count, scene.level.recoil ? scene.targets.count : 0);
  }

  /**
   * @param holds sorted and disjoint, as from `joinHolds`
   * @param isLate called before each tick: whether to stop. A later call with the same script continues near that point.
   */
  run(holds: readonly Hold[], isLate: () => boolean = () => false): RecordedRun {
    const resumedFrom = this.goBack(holds);
    this.played = holds;
    const { simulation, maxTicks } = this;
    let next = 0;
    let isCut = false;
    while (simulation.ending === null && simulation.tick < maxTicks) {
      const { tick } = simulation;
      if (isLate()) {
        isCut = true;
        break;
      }
      if (tick % SNAPSHOT_TICKS === 0) this.keep(tick / SNAPSHOT_TICKS);
      while (next < holds.length && holds[next][1] <= tick) next++;
      const isHeld = next < holds.length && holds[next][0] <= tick;
      if (this.ahead === 0) this.write();
      this.hold(tick, isHeld);
      if (!this.advance(isHeld)) {
        // the incomplete state within a tick is ignored
        this.ticks = tick;
        this.count = Math.max(1, this.count);
        this.last.set(this.room.states.subarray(STATE_SIZE * (this.count - 1), STATE_SIZE * this.count));
        return { way: this.way(), isCut: true, ending: null, minerals: [...this.minerals], resumedFrom };
      }
      this.collect(tick);
      if (this.ahead === 1) this.write();
    }
    if (this.ahead === 0 && simulation.ending === null) {
      this.hold(simulation.tick, false);
      this.write();
    }
    this.ticks = simulation.tick;
    simulation.readState(this.last);
    const { ending } = simulation;
    return { way: this.way(), isCut, ending, minerals: [...this.minerals], resumedFrom };
  }

  /** @returns false if the budget is used up */
  private advance(isHeld: boolean): boolean {
    try {
      this.simulation.advance(1, isHeld);
      return true;
    } catch (error) {
      if (error instanceof WorkLimitReached) return false;
      throw error;
    }
  }

  private way(): Way {
    const { count, last } = this;
    const { states, held, aliens, asteroids } = this.room;
    return { count, states, held, aliens, asteroids, last };
  }

  /** Restores the last snapshot that the script shares with the previous one. @returns its tick */
  private goBack(holds: readonly Hold[]): number {
    const shared = this.played === null ? 0 : Math.min(firstDifference(this.played, holds), this.ticks);
    const index = Math.min(Math.floor(shared / SNAPSHOT_TICKS), this.kept - 1);
    this.kept = Math.max(0, index + 1);
    if (index <= 0) {
      this.simulation.reset();
      this.minerals = [];
    } else {
      this.simulation.restore(this.room.snapshots[index]);
      this.minerals = this.minerals.filter(({ tick }) => tick < this.simulation.tick);
    }
    this.collected.fill(0);
    for (const mineral of this.minerals) this.collected[mineral.index] = 1;
    this.count = this.simulation.tick;
    return this.simulation.tick;
  }

  private keep(index: number): void {
    const { snapshots } = this.room;
    snapshots[index] = this.simulation.snapshot(snapshots[index]);
    this.kept = index + 1;
  }

  private collect(tick: number): void {
    const { simulation, collected } = this;
    if (simulation.mineralCount === this.minerals.length) return;
    for (let i = 0; i < collected.length; i++) {
      if (collected[i] === 1 || !simulation.isCollected(i)) continue;
      collected[i] = 1;
      this.minerals.push({ index: i, tick });
    }
  }

  private hold(tick: number, isHeld: boolean): void {
    this.room.grow(tick + 2);
    this.room.held[tick] = isHeld ? 1 : 0;
  }

  private write(): void {
    const { simulation, count, state, room } = this;
    room.grow(count + 2);
    simulation.readState(state);
    room.states.set(state, STATE_SIZE * count);
    // sleeping aliens, of which there may be hundreds, need not be read at every tick
    if (room.aliens.count > 0 && (count === 0 || simulation.mayAliensHaveStirred)) {
      simulation.readAliens(room.alienState);
      room.aliens.write(count, room.alienState);
    }
    if (room.asteroids.count > 0) {
      simulation.readAsteroids(room.asteroidState);
      room.asteroids.write(count, room.asteroidState);
    }
    this.count++;
  }
}

/**
 * Arrays for trajectories and snapshots. They are reused from scene to scene: a large level would allocate megabytes with every
 * move of the pointer.
 */
export class RecorderRoom {
  states = new Float64Array(0);
  held = new Uint8Array(0);
  readonly aliens = new Tracks(3);
  readonly asteroids = new Tracks(2);
  readonly snapshots: Float64Array[] = [];
  alienState = new Float64Array(0);
  asteroidState = new Float64Array(0);

  /** Prepares the arrays for a scene and discards those of another one. */
  prepare(aliens: number, asteroids: number): void {
    this.aliens.clear(aliens);
    this.asteroids.clear(asteroids);
    this.alienState = new Float64Array(aliens * this.aliens.size);
    this.asteroidState = new Float64Array(asteroids * this.asteroids.size);
  }

  /** Makes room for a number of entries. */
  grow(entries: number): void {
    if (this.held.length >= entries) return;
    const room = Math.max(entries, 2 * this.held.length, 1202);
    const states = new Float64Array(STATE_SIZE * room);
    states.set(this.states);
    this.states = states;
    const held = new Uint8Array(room);
    held.set(this.held);
    this.held = held;
  }
}

import {
  createSimulation,
  type Ending,
  type Scene,
  type Simulation,
  STATE_SIZE,
  unlimited,
  type WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { MarchRoom } from './march-room.ts';
import type { Tracks } from './tracks.ts';

/**
 * Where she was at every tick of a run, in arrays that are written anew by the next run: what is kept longer must be copied.
 * Entry k stands for the time k / 60 s; `count` entries are filled.
 */
export interface Way {
  readonly count: number;
  /** x, y (px), vx, vy (px/s), cos, sin of the box's x axis: `STATE_SIZE` doubles an entry. */
  readonly states: Float64Array;
  /** 1 where the gun is held in the tick that begins with this entry. */
  readonly held: Uint8Array;
  /** x, y, alive of every alien. */
  readonly aliens: Tracks;
  /** x, y of every asteroid in the level's order; none where recoil is off and they stand still. */
  readonly asteroids: Tracks;
  /** Her state when the run ended, between two ticks mostly: as in `states`. */
  readonly last: Float64Array;
}

/** How a run of a march ended. */
export interface Marched {
  readonly way: Way;
  /** Whether it was given up before the end. */
  readonly isCut: boolean;
  /** null: nothing ended it within the time */
  readonly ending: Ending | null;
  /** Indices of the minerals collected, in the order in which they were; two of one tick in the level's order. */
  readonly minerals: readonly { readonly index: number; readonly tick: number }[];
  /** The tick from which on it was simulated; all before was known from the last run. */
  readonly resumedFrom: number;
}

/** A snapshot every so many ticks: half of them is simulated twice at most, about. */
const SNAPSHOT_TICKS = 60;

/** The first tick at which two scripts differ; infinite where they are the same. Both sorted and disjoint. */
export function firstDifference(a: readonly Hold[], b: readonly Hold[]): number {
  for (let i = 0; i < Math.max(a.length, b.length); i++) {
    if (i >= a.length) return b[i][0];
    if (i >= b.length) return a[i][0];
    if (a[i][0] !== b[i][0]) return Math.min(a[i][0], b[i][0]);
    if (a[i][1] !== b[i][1]) return Math.min(a[i][1], b[i][1]);
  }
  return Number.POSITIVE_INFINITY;
}

/**
 * Plays scripts of one scene tick by tick and keeps the way. A script that begins as the last one did is taken up where they part, with the same bits
 * as from the start.
 */
export class March {
  private readonly simulation: Simulation;
  /** Under `arcade` the entry for time 0 is the state after the first frame, as in its recordings. */
  private readonly ahead: number;
  private readonly last = new Float64Array(STATE_SIZE);
  private readonly state = new Float64Array(STATE_SIZE);
  private minerals: { index: number; tick: number }[] = [];
  private readonly collected: Uint8Array;
  private played: readonly Hold[] | null = null;
  /** How many of the room's snapshots are of the script played. */
  private kept = 0;
  private count = 0;
  private ticks = 0;

  /**
   * @param room no other march may use it from now on
   * @param budget what may be played; a run that uses it up is cut
   * @throws WorkLimitReached where it is too small for the start
   */
  constructor(
    readonly scene: Scene,
    readonly maxTicks: number,
    private readonly room = new MarchRoom(),
    budget: WorkBudget = unlimited(),
  ) {
    this.simulation = createSimulation(scene, budget);
    this.ahead = scene.accuracy.integrator === 'arcade' ? 1 : 0;
    this.collected = new Uint8Array(scene.minerals.count);
    room.prepare(scene.aliens.count, scene.level.recoil ? scene.targets.count : 0);
  }

  /**
   * @param holds sorted and disjoint, as `joinHolds` gives them
   * @param isLate asked before each tick: whether to give up. Asked again for the same script, it goes on about where it gave up.
   */
  run(holds: readonly Hold[], isLate: () => boolean = () => false): Marched {
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
        // what it left in the middle of a tick is not looked at
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
    return { way: this.way(), isCut, ending: simulation.ending, minerals: [...this.minerals], resumedFrom };
  }

  /** @returns false: the budget is used up */
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

  /** Goes back to the last snapshot that the script shares with the one played before. @returns its tick */
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
    // of hundreds that sleep none need be looked at in every tick
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

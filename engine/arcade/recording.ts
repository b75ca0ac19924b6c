import { ChangeLog } from '../change-log.ts';
import { type Clearance, ClearanceTracker } from '../clearance.ts';
import { TICK, TICK_RATE } from '../constants.ts';
import { ALL_EFFECTS } from '../effects/index.ts';
import type { Scene } from '../scene.ts';
import { type BodyKind, type Outcome, type RunEvent, type Simulation, STATE_SIZE, type Trajectory } from '../simulation.ts';
import type { WorkBudget } from '../work-budget.ts';
import { SEEN_HELD, SEEN_TARGET } from './layout.ts';

/** Records every frame and event of an `arcade` run. Row f is the state after frame f and stands for time f / 60 s. */
export class FrameRecorder implements Trajectory {
  private rows: Float64Array;
  private count = 0;
  private readonly state = new Float64Array(STATE_SIZE);
  // the history of the other objects is kept separately: few of many move
  private chaserLog: ChangeLog | null = null;
  private asteroidLog: ChangeLog | null = null;
  private readonly chasers: Float64Array;
  private readonly asteroids: Float64Array;
  private readonly asteroidsMove: boolean;

  /**
   * @param budget - limits the work and memory of the recording, and the work of computing the clearance
   * @param keeps - false to keep events only
   * @param events - receives the events
   */
  constructor(
    private readonly scene: Scene,
    private readonly budget: WorkBudget,
    private readonly keeps = true,
    readonly events: RunEvent[] = [],
  ) {
    this.chasers = new Float64Array(3 * scene.aliens.count);
    this.asteroids = new Float64Array(2 * scene.targets.count);
    this.asteroidsMove = scene.level.recoil;
    this.rows = new Float64Array(STATE_SIZE * 1024);
  }

  get duration(): number {
    return this.count === 0 ? 0 : (this.count - 1) * TICK;
  }

  at(time: number, out: Float64Array): void {
    this.read(this.rowAt(time), out);
  }

  aliensAt(time: number, out: Float64Array): void {
    this.chaserLog?.seek(this.rowAt(time), this.chasers);
    out.set(this.chasers);
  }

  asteroidsAt(time: number, out: Float64Array): void {
    if (this.asteroidsMove) {
      this.asteroidLog?.seek(this.rowAt(time), this.asteroids);
      out.set(this.asteroids);
      return;
    }
    for (const [i, { x, y }] of this.scene.level.asteroids.entries()) {
      out[2 * i] = x;
      out[2 * i + 1] = y;
    }
  }

  /** The smallest gap to a hazard at any frame. */
  clearance(): Clearance | null {
    const { scene, state, chasers, asteroids } = this;
    const near = new ClearanceTracker(scene, ALL_EFFECTS.hazardsOf(scene));
    this.asteroidsAt(0, asteroids);
    for (let row = 0; row < this.count; row++) {
      this.budget.look(1 + near.count / 8);
      this.read(row, state);
      this.chaserLog?.seek(row, chasers);
      this.asteroidLog?.seek(row, asteroids);
      near.see(row * TICK, state[0], state[1], state[4], state[5], chasers, asteroids);
    }
    return near.best;
  }

  private rowAt(time: number): number {
    // the addend keeps k / 60 * 60 from falling below k
    return Math.min(this.count - 1, Math.max(0, Math.floor(time * TICK_RATE + 1e-6)));
  }

  private read(row: number, out: Float64Array): void {
    for (let i = 0; i < STATE_SIZE; i++) out[i] = this.rows[STATE_SIZE * row + i];
  }

  /** Records the state of a simulation at the end of a frame. */
  row(simulation: Simulation): void {
    if (!this.keeps) return;
    const { state, chasers, asteroids, budget } = this;
    if (STATE_SIZE * this.count === this.rows.length) {
      const grown = new Float64Array(2 * this.rows.length);
      grown.set(this.rows);
      this.rows = grown;
    }
    simulation.readState(state);
    this.rows.set(state, STATE_SIZE * this.count);
    budget.record(8 * STATE_SIZE);
    if (chasers.length > 0) {
      simulation.readAliens(chasers);
      this.chaserLog ??= new ChangeLog(3, chasers, budget);
      this.chaserLog.next();
      for (let i = 0; 3 * i < chasers.length; i++) this.chaserLog.set(i, chasers, 3 * i);
      budget.look(chasers.length >> 4);
    }
    if (this.asteroidsMove) {
      simulation.readAsteroids(asteroids);
      this.asteroidLog ??= new ChangeLog(2, asteroids, budget);
      this.asteroidLog.next();
      for (let i = 0; 2 * i < asteroids.length; i++) this.asteroidLog.set(i, asteroids, 2 * i);
      budget.look(asteroids.length >> 4);
    }
    this.count++;
  }

  /** @param s - the state, which remembers what was last reported, so that a restored simulation goes on as it would have */
  button(s: Float64Array, frame: number, held: boolean, nearest: number): void {
    const time = frame * TICK;
    const wasHeld = s[SEEN_HELD] === 1;
    const pressed = held && !wasHeld;
    const before = s[SEEN_TARGET];
    s[SEEN_TARGET] = nearest;
    if (held !== wasHeld) this.events.push({ time, type: held ? 'press' : 'release' });
    if (held && nearest >= 0 && (pressed || nearest !== before)) {
      this.events.push({ time, type: 'target', index: this.scene.targets.index[nearest] });
    }
    s[SEEN_HELD] = held ? 1 : 0;
  }

  collected(frame: number, index: number): void {
    this.events.push({ time: frame * TICK, type: 'mineral', index });
  }

  alertness(frame: number, index: number, awake: boolean): void {
    this.events.push({ time: frame * TICK, type: awake ? 'wake' : 'sleep', index });
  }

  explosion(frame: number, a: number, b: number): void {
    this.events.push({ time: frame * TICK, type: 'explosion', aliens: [a, b] });
  }

  event(event: RunEvent): void {
    this.events.push(event);
  }

  end(frame: number, type: Exclude<Outcome, 'timeout'>, kind: BodyKind | null, index: number): void {
    this.events.push({ time: frame * TICK, type, with: kind === null ? null : { kind, index } });
  }
}

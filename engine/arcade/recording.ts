import { type Clearance, ClearanceTracker } from '../clearance.ts';
import { TICK, TICK_RATE } from '../constants.ts';
import type { Scene } from '../scene.ts';
import { type BodyKind, type Outcome, type RunEvent, type Simulation, STATE_SIZE } from '../simulation.ts';
import type { Trajectory } from '../trajectory.ts';

/** Keeps every frame and event of an `arcade` run. Row f is the state after frame f and stands for time f / 60 s. */
export class FrameRecorder implements Trajectory {
  readonly events: RunEvent[] = [];
  private readonly width: number;
  private rows: Float64Array;
  private count = 0;
  private wasHeld = false;
  private lastNearest = -1;
  private lastField = -1;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly aliens: Float64Array;
  private readonly asteroids: Float64Array;
  private readonly asteroidsMove: boolean;

  constructor(private readonly scene: Scene) {
    this.aliens = new Float64Array(3 * scene.aliens.count);
    this.asteroids = new Float64Array(2 * scene.targets.count);
    this.asteroidsMove = scene.level.recoil;
    this.width = STATE_SIZE + this.aliens.length + (this.asteroidsMove ? this.asteroids.length : 0);
    this.rows = new Float64Array(this.width * 1024);
  }

  get duration(): number {
    return this.count === 0 ? 0 : (this.count - 1) * TICK;
  }

  at(time: number, out: Float64Array): void {
    this.read(this.rowAt(time), 0, STATE_SIZE, out);
  }

  aliensAt(time: number, out: Float64Array): void {
    this.read(this.rowAt(time), STATE_SIZE, this.aliens.length, out);
  }

  asteroidsAt(time: number, out: Float64Array): void {
    if (this.asteroidsMove) {
      this.read(this.rowAt(time), STATE_SIZE + this.aliens.length, this.asteroids.length, out);
      return;
    }
    for (const [i, { x, y }] of this.scene.level.asteroids.entries()) {
      out[2 * i] = x;
      out[2 * i + 1] = y;
    }
  }

  /** The smallest gap to a hazard at any frame. */
  clearance(): Clearance | null {
    const { scene, state, aliens, asteroids } = this;
    const near = new ClearanceTracker(scene);
    this.asteroidsAt(0, asteroids);
    for (let row = 0; row < this.count; row++) {
      this.read(row, 0, STATE_SIZE, state);
      this.read(row, STATE_SIZE, aliens.length, aliens);
      if (this.asteroidsMove) this.read(row, STATE_SIZE + aliens.length, asteroids.length, asteroids);
      near.see(row * TICK, state[0], state[1], state[4], state[5], aliens, asteroids);
    }
    return near.best;
  }

  private rowAt(time: number): number {
    // the sum keeps k / 60 * 60 from falling below k
    return Math.min(this.count - 1, Math.max(0, Math.floor(time * TICK_RATE + 1e-6)));
  }

  private read(row: number, from: number, length: number, out: Float64Array): void {
    const o = this.width * row + from;
    for (let i = 0; i < length; i++) out[i] = this.rows[o + i];
  }

  private write(from: number, values: Float64Array): void {
    const o = this.width * this.count + from;
    for (let i = 0; i < values.length; i++) this.rows[o + i] = values[i];
  }

  /** Keeps the state of a simulation at the end of a frame. */
  row(simulation: Simulation): void {
    if (this.width * this.count === this.rows.length) {
      const grown = new Float64Array(2 * this.rows.length);
      grown.set(this.rows);
      this.rows = grown;
    }
    simulation.readState(this.state);
    this.write(0, this.state);
    if (this.aliens.length > 0) {
      simulation.readAliens(this.aliens);
      this.write(STATE_SIZE, this.aliens);
    }
    if (this.asteroidsMove) {
      simulation.readAsteroids(this.asteroids);
      this.write(STATE_SIZE + this.aliens.length, this.asteroids);
    }
    this.count++;
  }

  button(frame: number, held: boolean, nearest: number): void {
    const time = frame * TICK;
    const pressed = held && !this.wasHeld;
    const before = this.lastNearest;
    this.lastNearest = nearest;
    if (held !== this.wasHeld) this.events.push({ time, type: held ? 'press' : 'release' });
    if (held && nearest >= 0 && (pressed || nearest !== before)) {
      this.events.push({ time, type: 'target', index: this.scene.targets.index[nearest] });
    }
    this.wasHeld = held;
  }

  field(frame: number, now: number): void {
    const before = this.lastField;
    if (now === before) return;
    this.lastField = now;
    if (before >= 0) this.events.push({ time: frame * TICK, type: 'leave', index: before });
    if (now >= 0) this.events.push({ time: frame * TICK, type: 'enter', index: now });
  }

  mineral(frame: number, index: number): void {
    this.events.push({ time: frame * TICK, type: 'mineral', index });
  }

  alien(frame: number, index: number, awake: boolean): void {
    this.events.push({ time: frame * TICK, type: awake ? 'wake' : 'sleep', index });
  }

  explosion(frame: number, a: number, b: number): void {
    this.events.push({ time: frame * TICK, type: 'explosion', aliens: [a, b] });
  }

  end(frame: number, type: Exclude<Outcome, 'timeout'>, kind: BodyKind | null, index: number): void {
    this.events.push({ time: frame * TICK, type, with: kind === null ? null : { kind, index } });
  }
}

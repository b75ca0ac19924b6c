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
  private readonly near: ClearanceTracker;
  private readonly aliens: Float64Array;
  private readonly asteroids: Float64Array;

  constructor(private readonly scene: Scene) {
    this.aliens = new Float64Array(3 * scene.aliens.count);
    this.asteroids = new Float64Array(2 * scene.targets.count);
    this.width = STATE_SIZE + this.aliens.length;
    this.rows = new Float64Array(this.width * 1024);
    this.near = new ClearanceTracker(scene);
  }

  get clearance(): Clearance | null {
    return this.near.best;
  }

  get duration(): number {
    return this.count === 0 ? 0 : (this.count - 1) * TICK;
  }

  at(time: number, out: Float64Array): void {
    const o = this.width * this.rowAt(time);
    for (let i = 0; i < STATE_SIZE; i++) out[i] = this.rows[o + i];
  }

  aliensAt(time: number, out: Float64Array): void {
    const o = this.width * this.rowAt(time) + STATE_SIZE;
    for (let i = 0; i < this.aliens.length; i++) out[i] = this.rows[o + i];
  }

  private rowAt(time: number): number {
    // the sum keeps k / 60 * 60 from falling below k
    return Math.min(this.count - 1, Math.max(0, Math.floor(time * TICK_RATE + 1e-6)));
  }

  /** Keeps the state of a simulation at the end of a frame. */
  row(simulation: Simulation): void {
    const o = this.width * this.count;
    if (o === this.rows.length) {
      const grown = new Float64Array(2 * this.rows.length);
      grown.set(this.rows);
      this.rows = grown;
    }
    const row = this.rows.subarray(o, o + this.width);
    simulation.readState(row);
    simulation.readAliens(this.aliens);
    simulation.readAsteroids(this.asteroids);
    row.set(this.aliens, STATE_SIZE);
    this.near.see(this.count * TICK, row[0], row[1], row[4], row[5], this.aliens, this.asteroids);
    this.count++;
  }

  button(frame: number, held: boolean, nearest: number, before: number): void {
    const time = frame * TICK;
    const pressed = held && !this.wasHeld;
    if (held !== this.wasHeld) this.events.push({ time, type: held ? 'press' : 'release' });
    if (held && nearest >= 0 && (pressed || nearest !== before)) {
      this.events.push({ time, type: 'target', index: this.scene.targets.index[nearest] });
    }
    this.wasHeld = held;
  }

  field(frame: number, before: number, now: number): void {
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

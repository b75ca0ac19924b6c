import { type Clearance, ClearanceTracker } from '../clearance.ts';
import { TICK_RATE } from '../constants.ts';
import type { Scene } from '../scene.ts';
import { type RunEvent, STATE_SIZE } from '../simulation.ts';
import type { Trajectory } from '../trajectory.ts';
import { ContinuousSimulation } from './simulation.ts';

/** Places at which each piece is looked at for the smallest clearance, before the best one is refined. */
const LOOKS = 8;
const MOST_LOOKS = 4096;

/** Keeps every piece and event of a run in continuous time. */
export class PieceRecorder implements Trajectory {
  readonly events: RunEvent[] = [];
  private states: Float64Array[] = [];
  private starts: number[] = [];
  private lengths: number[] = [];
  private end = 0;
  private readonly reader: ContinuousSimulation;
  private readonly near: ClearanceTracker;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly aliens: Float64Array;
  private readonly asteroids: Float64Array;

  constructor(private readonly scene: Scene) {
    this.reader = new ContinuousSimulation(scene);
    this.near = new ClearanceTracker(scene);
    this.aliens = new Float64Array(3 * scene.aliens.count);
    this.asteroids = new Float64Array(2 * scene.targets.count);
  }

  /** Keeps the piece the simulation is on; it is left after `t` seconds. */
  piece(simulation: ContinuousSimulation, t: number): void {
    this.end = simulation.pieceStart + t;
    if (t <= 0 && this.starts.length > 0) return;
    this.states.push(simulation.snapshot());
    this.starts.push(simulation.pieceStart);
    this.lengths.push(t);
  }

  event(event: RunEvent): void {
    this.events.push(event);
  }

  get duration(): number {
    return this.end;
  }

  at(time: number, out: Float64Array): void {
    this.reader.stateAt(this.open(time), out);
  }

  aliensAt(time: number, out: Float64Array): void {
    this.reader.aliensAt(this.open(time), out);
  }

  asteroidsAt(time: number, out: Float64Array): void {
    this.reader.asteroidsAt(this.open(time), out);
  }

  /** Puts the reader on the piece that holds at `time`; returns the time since it began. */
  private open(time: number): number {
    const t = Math.min(this.end, Math.max(0, time));
    let low = 0;
    let high = this.starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.starts[middle] <= t) low = middle;
      else high = middle - 1;
    }
    this.reader.restore(this.states[low]);
    // between whole periods that were skipped she is shown where the last piece left her
    return Math.min(this.lengths[low], Math.max(0, t - this.starts[low]));
  }

  /** The smallest gap to a hazard: from looks along every piece, the best of them refined. */
  clearance(): Clearance | null {
    if (this.scene.novae.count + this.scene.aliens.count + this.scene.targets.count - this.scene.coldCount === 0) return null;
    let bestPiece = 0;
    let bestTime = 0;
    let stride = 0;
    for (let i = 0; i < this.starts.length; i++) {
      const length = this.lengths[i];
      // a long piece is looked at as often as at ticks
      const looks = Math.max(LOOKS, Math.min(MOST_LOOKS, Math.ceil(length * TICK_RATE)));
      this.reader.restore(this.states[i]);
      for (let k = 0; k <= looks; k++) {
        const before = this.near.best;
        const t = (length * k) / looks;
        this.look(this.starts[i], t);
        if (this.near.best === before) continue;
        bestPiece = i;
        bestTime = t;
        stride = length / looks;
      }
    }
    this.refine(bestPiece, bestTime, stride);
    return this.near.best;
  }

  /** Halves the stride around the best look until it no longer matters. */
  private refine(piece: number, time: number, stride: number): void {
    this.reader.restore(this.states[piece]);
    let t = time;
    for (let h = stride / 2; h > 1e-9; h /= 2) {
      for (const side of [t - h, t + h]) {
        if (side < 0 || side > this.lengths[piece]) continue;
        const before = this.near.best;
        this.look(this.starts[piece], side);
        if (this.near.best !== before) t = side;
      }
    }
  }

  private look(start: number, t: number): void {
    const { reader, state, aliens, asteroids } = this;
    reader.stateAt(t, state);
    reader.aliensAt(t, aliens);
    reader.asteroidsAt(t, asteroids);
    this.near.see(start + t, state[0], state[1], state[4], state[5], aliens, asteroids);
  }
}

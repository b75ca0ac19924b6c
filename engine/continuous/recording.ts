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
    for (let i = 0; i < this.starts.length; i++) {
      const length = this.lengths[i];
      // a long piece is looked at as often as at ticks
      const looks = length > 0 ? Math.max(LOOKS, Math.min(MOST_LOOKS, Math.ceil(length * TICK_RATE))) : 0;
      const stride = looks > 0 ? length / looks : 0;
      this.reader.restore(this.states[i]);
      let before = Number.POSITIVE_INFINITY;
      let last = this.look(this.starts[i], 0);
      for (let k = 1; k <= looks; k++) {
        const gap = this.look(this.starts[i], stride * k);
        // a dip between two looks may be deeper than the best so far
        if (last <= before && last <= gap) this.refine(i, stride * (k - 1), stride, last, gap);
        before = last;
        last = gap;
      }
      if (looks > 0 && last <= before) this.refine(i, length, stride, last, last);
    }
    return this.near.best;
  }

  /** Looks closer around a dip, where it may be the deepest: halves the stride until it no longer matters. */
  private refine(piece: number, time: number, stride: number, gap: number, beside: number): void {
    const best = this.near.best;
    if (best !== null && gap > best.distance + Math.max(1, beside - gap)) return;
    const start = this.starts[piece];
    let t = time;
    let least = gap;
    for (let h = stride / 2; h > 1e-9; h /= 2) {
      for (let side = -1; side <= 1; side += 2) {
        const there = t + side * h;
        if (there < 0 || there > this.lengths[piece]) continue;
        const found = this.look(start, there);
        if (found >= least) continue;
        least = found;
        t = there;
        break;
      }
    }
  }

  private look(start: number, t: number): number {
    const { reader, state, aliens, asteroids } = this;
    reader.stateAt(t, state);
    reader.aliensAt(t, aliens);
    reader.asteroidsAt(t, asteroids);
    return this.near.see(start + t, state[0], state[1], state[4], state[5], aliens, asteroids);
  }
}

import { type Clearance, ClearanceTracker } from '../clearance.ts';
import type { Scene } from '../scene.ts';
import type { RunEvent } from '../simulation.ts';
import type { Trajectory } from '../trajectory.ts';
import { ContinuousSimulation } from './simulation.ts';

/** Pieces at whose beginning the clearance is looked for before it is looked for everywhere. */
const FIRST_LOOKS = 64;

/** Keeps every piece and event of a run in continuous time. */
export class PieceRecorder implements Trajectory {
  readonly events: RunEvent[] = [];
  private states: Float64Array[] = [];
  private starts: number[] = [];
  private lengths: number[] = [];
  private end = 0;
  /** Stands on the piece that was asked for last; made when the first is. */
  private reader: ContinuousSimulation | null = null;
  private readerAt = -1;

  constructor(private readonly scene: Scene) {}

  /** Keeps the piece that began at `start` s, with the state at its beginning; it is left after `t` seconds. */
  piece(start: number, state: Float64Array, t: number): void {
    this.end = start + t;
    this.states.push(state);
    this.starts.push(start);
    this.lengths.push(t);
  }

  event(event: RunEvent): void {
    this.events.push(event);
  }

  get duration(): number {
    return this.end;
  }

  at(time: number, out: Float64Array): void {
    const piece = this.pieceAt(time);
    this.open(piece).stateAt(this.sinceStart(piece, time), out);
  }

  aliensAt(time: number, out: Float64Array): void {
    const piece = this.pieceAt(time);
    this.open(piece).aliensAt(this.sinceStart(piece, time), out);
  }

  asteroidsAt(time: number, out: Float64Array): void {
    const piece = this.pieceAt(time);
    this.open(piece).asteroidsAt(this.sinceStart(piece, time), out);
  }

  /** The last piece that began by `time`. */
  private pieceAt(time: number): number {
    const { starts } = this;
    // asked in order, as samples are, the answer is the same piece or the next
    let low = this.readerAt >= 0 && starts[this.readerAt] <= time ? this.readerAt : 0;
    let high = low + 1 < starts.length && starts[low + 1] > time ? low : starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (starts[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Between whole periods that were skipped she is shown where the last piece left her. */
  private sinceStart(piece: number, time: number): number {
    return Math.min(this.lengths[piece], Math.max(0, time - this.starts[piece]));
  }

  /** The reader, on a piece. */
  private open(piece: number): ContinuousSimulation {
    this.reader ??= new ContinuousSimulation(this.scene);
    if (this.readerAt !== piece) this.reader.restore(this.states[piece]);
    this.readerAt = piece;
    return this.reader;
  }

  /** The smallest gap to a hazard. */
  clearance(): Clearance | null {
    const { scene, events } = this;
    if (scene.novae.count + scene.aliens.count + scene.targets.count - scene.coldCount === 0) return null;
    const near = new ClearanceTracker(scene);
    // a few looks all along the run first: of what stays farther than the nearest of them the rest sees little
    const stride = Math.ceil(this.starts.length / FIRST_LOOKS);
    for (let i = 0; i < this.starts.length; i += stride) this.open(i).approach(0, near);
    for (let i = 0; i < this.starts.length; i++) this.open(i).approach(this.lengths[i], near);
    const { best } = near;
    if (best === null || scene.accuracy.contact === 'frame') return best;
    // rounding must not tell another story than the run: it ended with the contact, or there was none
    const touched = events.at(-1)?.type === 'collided';
    return { ...best, distance: touched ? Math.min(0, best.distance) : Math.max(0, best.distance) };
  }
}

import { ChangeLog } from '../change-log.ts';
import { type Clearance, ClearanceTracker } from '../clearance.ts';
import { GUN_PULL, HALF_DIAGONAL, HALF_WIDTH, TICK_RATE } from '../constants.ts';
import type { Scene } from '../scene.ts';
import { type RunEvent, STATE_SIZE } from '../simulation.ts';
import type { Trajectory } from '../trajectory.ts';
import { unlimited, type WorkBudget } from '../work-budget.ts';
import type { Motion } from './motion.ts';
import { packPiece } from './packed-piece.ts';
import { ContinuousSimulation } from './simulation.ts';
import { RECORDS, SLOTS } from './state.ts';

const { START, AWAKE_COUNT } = SLOTS;
const { CHASER, ROCK } = RECORDS;

/** What keeping a piece takes beside its numbers, bytes. */
const BYTES_A_PIECE = 128;

/** Places at which each piece is looked at for the smallest clearance, before the best one is refined. */
const LOOKS = 8;
const MOST_LOOKS = 4096;

/** Where looking closer ends, s: about its dip the gap changes with the square of this. */
const FINEST = 1e-7;

/** Keeps every piece and event of a run in continuous time. */
export class PieceRecorder implements Trajectory {
  readonly events: RunEvent[] = [];
  /** Of each piece what {@link packPiece} keeps; what becomes of chasers and rocks is apart. */
  private states: Float64Array[] = [];
  private chasers: ChangeLog | null = null;
  private rocks: ChangeLog | null = null;
  private starts: number[] = [];
  private lengths: number[] = [];
  private end = 0;
  /** Stands on the piece that was asked for last; made when the first is. */
  private reader: ContinuousSimulation | null = null;
  private readerAt = -1;
  private readonly near: ClearanceTracker;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly aliens: Float64Array;
  private readonly asteroids: Float64Array;
  private readonly othersMove: boolean;
  /** What looking at her and all that is deadly costs. */
  private readonly looksAtOnce: number;

  /** @param budget what the recording, and looking for the clearance, may cost */
  constructor(
    private readonly scene: Scene,
    private readonly budget: WorkBudget = unlimited(),
  ) {
    this.othersMove = scene.level.recoil || scene.aliens.count > 0;
    this.near = new ClearanceTracker(scene);
    const { novae, aliens, targets, coldCount } = scene;
    this.looksAtOnce = 4 + (novae.count + 2 * aliens.count + targets.count - (this.othersMove ? 0 : coldCount)) / 8;
    this.aliens = new Float64Array(3 * scene.aliens.count);
    this.asteroids = new Float64Array(2 * scene.targets.count);
  }

  /** Keeps the piece that the motion is on; it is left after `t` seconds. */
  piece(motion: Motion, t: number): void {
    const { s, crowd, budget, chasers, rocks, minerals, stirred } = motion;
    const state = packPiece(motion);
    budget.record(8 * state.length + BYTES_A_PIECE);
    const start = s[START];
    this.end = start + t;
    this.states.push(state);
    this.starts.push(start);
    this.lengths.push(t);
    if (rocks > chasers) {
      this.chasers ??= new ChangeLog(CHASER, s.subarray(chasers, rocks), budget);
      this.chasers.next();
      for (let k = 0; k < s[AWAKE_COUNT]; k++) this.chasers.set(crowd.awake[k], s, chasers + CHASER * crowd.awake[k]);
      for (const i of crowd.altered) this.chasers.set(i, s, chasers + CHASER * i);
      crowd.altered.length = 0;
      const { count } = this.scene.aliens;
      if (motion.recoils) this.chasers.set(count, s, chasers + CHASER * count);
    }
    if (minerals > rocks) {
      this.rocks ??= new ChangeLog(ROCK, s.subarray(rocks, minerals), budget);
      this.rocks.next();
      for (const i of stirred) this.rocks.set(i, s, rocks + ROCK * i);
    }
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
    if (this.readerAt === piece) return this.reader;
    this.readerAt = piece;
    this.reader.resumePiece(this.states[piece], (chasers, rocks) => {
      this.chasers?.seek(piece, chasers);
      this.rocks?.seek(piece, rocks);
    });
    return this.reader;
  }

  /** The smallest gap to a hazard: from looks along every piece, the best of them refined. */
  clearance(): Clearance | null {
    if (this.scene.novae.count + this.scene.aliens.count + this.scene.targets.count - this.scene.coldCount === 0) return null;
    this.open(0).asteroidsAt(0, this.asteroids);
    for (let i = 0; i < this.starts.length; i++) {
      const length = this.lengths[i];
      // a long piece is looked at as often as at ticks
      const looks = length > 0 ? Math.max(LOOKS, Math.min(MOST_LOOKS, Math.ceil(length * TICK_RATE))) : 0;
      const stride = looks > 0 ? length / looks : 0;
      let before = Number.POSITIVE_INFINITY;
      let last = this.look(i, 0);
      for (let k = 1; k <= looks; k++) {
        const quiet = this.quietTime(last, length - stride * (k - 1));
        if (quiet > 2 * stride) {
          k = Math.min(looks, k - 1 + Math.floor(quiet / stride));
          last = Number.POSITIVE_INFINITY;
        }
        const gap = this.look(i, stride * k);
        // a dip between two looks may be deeper than the best so far
        if (last <= before && last <= gap) this.refine(i, stride * (k - 1), stride, last, gap);
        before = last;
        last = gap;
      }
      if (looks > 0 && last <= before) this.refine(i, length, stride, last, last);
    }
    return this.near.best;
  }

  /** For how long after the last look the gap stays above the best, s; 0 where other bodies move too. */
  private quietTime(gap: number, left: number): number {
    const best = this.near.best;
    if (best === null || this.othersMove) return 0;
    // however the box turns, the gap is at most this much larger than the distance of its circumcircle
    const slack = gap - (HALF_DIAGONAL - HALF_WIDTH) - best.distance;
    if (slack <= 0) return 0;
    const [, , vx, vy] = this.state;
    return slack / (Math.sqrt(vx * vx + vy * vy) + GUN_PULL * left + 1e-9);
  }

  /** Looks closer around a dip, where it may be the deepest: halves the stride until it no longer matters. */
  private refine(piece: number, time: number, stride: number, gap: number, beside: number): void {
    const best = this.near.best;
    // moving and turning she can come nearer by no more than this within a stride
    const [, , vx, vy] = this.state;
    const nearer = 3 * Math.sqrt(vx * vx + vy * vy) * stride + beside - gap;
    if (best !== null && gap > best.distance + nearer) return;
    let t = time;
    let least = gap;
    for (let h = stride / 2; h > FINEST; h /= 2) {
      for (let side = -1; side <= 1; side += 2) {
        const there = t + side * h;
        if (there < 0 || there > this.lengths[piece]) continue;
        const found = this.look(piece, there);
        if (found >= least) continue;
        least = found;
        t = there;
        break;
      }
    }
  }

  private look(piece: number, t: number): number {
    this.budget.look(this.looksAtOnce);
    const { state, aliens, asteroids } = this;
    const reader = this.open(piece);
    reader.stateAt(t, state);
    if (this.othersMove) {
      reader.aliensAt(t, aliens);
      reader.asteroidsAt(t, asteroids);
    }
    return this.near.see(this.starts[piece] + t, state[0], state[1], state[4], state[5], aliens, asteroids);
  }
}

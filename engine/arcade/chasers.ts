import { EXPLOSION_FRAMES, TICK, TICK_RATE } from '../constants.ts';
import { type Box, boxOverlapsCircle, circlesOverlap } from '../contact.ts';
import { ALL_EFFECTS } from '../effects/index.ts';
import { NO_CIRCLES } from '../indexed-circles.ts';
import type { ChaserCircles } from '../motion/index.ts';
import type { Scene } from '../scene.ts';
import type { WorkBudget } from '../work-budget.ts';
import { COS, FRAME, limitSpeed, ROUSED, SIN, VX, VY, X, Y } from './layout.ts';
import type { Neighbourhood } from './neighbourhoods.ts';
import type { FrameRecorder } from './recording.ts';

/** Doubles per chaser: place, velocity, acceleration, and what it is doing. */
const CHASER_SIZE = 7;
const ASLEEP = 0;
const AWAKE = 1;
// the last double of an exploded chaser is FUSE + the frame in which it stops chasing
const FUSE = 2;

/** The lookahead covers at most this many frames. */
export const AHEAD = 16;
/** Whether two of them can touch is examined for this many frames ahead. */
const APART_FRAMES = 60;
/** Resting chasers that are farther than this from mattering are ignored, px. */
const NEAR = 8;

const NOBODY: ChaserCircles = { ...NO_CIRCLES, explosions: NO_CIRCLES.index };

const DT = TICK; // V8 folds constants of the same module

/** The chasers of a simulation, in its state from `offset` on. */
export class Chasers {
  /** Doubles of state for this many chasers. */
  static length(count: number): number {
    return CHASER_SIZE * count;
  }

  readonly end: number;
  /** As the level places them. */
  readonly circles: ChaserCircles;
  readonly count: number;
  /** How many chasers the last lookahead examined. */
  looked = 0;
  private readonly r: Float64Array;
  private readonly box: Box;
  private readonly pull: number;
  readonly sight: number;
  private readonly speedLimit: number;
  // after k frames from rest at acceleration a, a body has moved by a k (k + 1) / 2 frames^2. From that, upper bounds of the mean
  // speed of approach that a chaser and she, and two chasers, gain within the lookahead, px/s
  private readonly haste: number;
  private readonly apartHaste: number;
  /** Chasers no faster than this, both axes together, px/s, do not reach the speed limit within the lookahead. */
  private readonly fast: number;
  // while she is nearer than this to (calmX, calmY), px, all of them rest; derived from the state, and dropped when that is
  // replaced
  private calmX = 0;
  private calmY = 0;
  private calm = -1;
  /** Before this frame no two of them can touch; derived likewise. */
  private apartUntil = -1;
  /** Frames in which no moving chaser can touch her or another one. */
  ahead = Number.POSITIVE_INFINITY;
  /** How far she may move before a resting chaser matters, px. */
  room = Number.POSITIVE_INFINITY;
  /** How many of them move or may soon do so. */
  moving = 0;
  /** Their indices. */
  private readonly mobile: Int32Array;
  /** Chasers that may have begun to touch another one since touches were last examined. */
  private readonly restless: number[] = [];
  private readonly isRestless: Uint8Array;

  constructor(
    private readonly s: Float64Array,
    scene: Scene,
    private readonly offset: number,
    private readonly budget: WorkBudget,
  ) {
    const chase = ALL_EFFECTS.chaseOf(scene.effects);
    this.circles = chase?.circles(scene) ?? NOBODY;
    this.count = this.circles.count;
    this.r = this.circles.r;
    const { speedLimit } = scene.rules;
    this.pull = chase?.pull(scene.rules) ?? 0;
    this.sight = chase?.sight(scene.rules) ?? 0;
    const hers = scene.strongest;
    this.box = scene.box;
    this.speedLimit = speedLimit;
    this.haste = ((this.pull + hers + 1) * (AHEAD + 1) * TICK) / 2;
    this.apartHaste = ((2 * this.pull + 1) * (APART_FRAMES + 1) * TICK) / 2;
    this.fast = speedLimit - (Math.max(hers, this.pull) * AHEAD + 1) * TICK;
    this.end = offset + CHASER_SIZE * this.count;
    this.mobile = new Int32Array(this.count);
    this.isRestless = new Uint8Array(this.count);
  }

  layOut(s: Float64Array): void {
    const { circles } = this;
    for (let i = 0; i < this.count; i++) {
      const o = this.offset + CHASER_SIZE * i;
      // adding 0 turns -0 into 0, as moving by 0 would
      s[o] = circles.x[i] + 0;
      s[o + 1] = circles.y[i] + 0;
      if (circlesOverlap(s[X] - s[o], s[Y] - s[o + 1], this.sight)) {
        s[o + 6] = AWAKE;
        s[ROUSED] = 1;
      }
    }
    if (circles.explosions.length > 0) s[ROUSED] = 1;
  }

  /** Drops what was derived from the state, after this was replaced. */
  forget(): void {
    const { s, count, circles } = this;
    this.calm = -1;
    this.forgetRestless();
    if (s[ROUSED] === 0) return;
    for (let i = 0; i < count; i++) {
      const o = this.offset + CHASER_SIZE * i;
      const rests = s[o + 6] === ASLEEP && s[o + 2] === 0 && s[o + 3] === 0;
      if (!rests || s[o] !== circles.x[i] || s[o + 1] !== circles.y[i]) this.disturb(i);
    }
  }

  /** Marks a chaser that may touch another one from now on. */
  private disturb(i: number): void {
    if (this.isRestless[i] === 1) return;
    this.isRestless[i] = 1;
    this.restless.push(i);
    this.apartUntil = -1;
  }

  /** No two of them touch now. */
  private forgetRestless(): void {
    for (const i of this.restless) this.isRestless[i] = 0;
    this.restless.length = 0;
    this.apartUntil = -1;
  }

  /** Whether, after {@link lookAhead}, none of them moves, wakes or touches before she has moved by `room`. */
  get rest(): boolean {
    return this.moving === 0 && this.room > NEAR;
  }

  /**
   * Finds out for how long nothing but chasing can happen. `ahead`, `room` and `moving` say so until the next frame is made.
   */
  lookAhead(cell: Neighbourhood): void {
    const { s, r, count, sight, haste } = this;
    const { halfDiagonal } = this.box;
    this.moving = 0;
    this.looked = 0;
    this.ahead = Number.POSITIVE_INFINITY;
    this.room = Number.POSITIVE_INFINITY;
    if (s[ROUSED] === 0 && cell.unseen) return;
    const x = s[X];
    const y = s[Y];
    if (this.calm > 0) {
      this.room = this.calm - Math.sqrt((x - this.calmX) * (x - this.calmX) + (y - this.calmY) * (y - this.calmY));
      if (this.room > NEAR) return;
    }
    const frame = s[FRAME];
    // two that touch at their places in the level explode in the first frame, though they rest
    if (frame === 0) {
      this.ahead = 0;
      this.room = 0;
      return;
    }
    const vx = s[VX];
    const vy = s[VY];
    this.looked = count;
    let moving = 0;
    let fastest = Math.abs(vx) + Math.abs(vy);
    let room = Number.POSITIVE_INFINITY;
    let time = AHEAD * DT;
    for (let i = 0; i < count; i++) {
      const o = this.offset + CHASER_SIZE * i;
      const dx = s[o] - x;
      const dy = s[o + 1] - y;
      const d = Math.sqrt(dx * dx + dy * dy);
      const reach = halfDiagonal + r[i];
      const state = s[o + 6];
      const itsVX = s[o + 2];
      const itsVY = s[o + 3];
      if (itsVX === 0 && itsVY === 0 && s[o + 4] === 0 && s[o + 5] === 0) {
        const dead = state >= FUSE && frame >= state - FUSE;
        const gap = d * (1 - 1e-9) - (dead || reach > sight ? reach : sight) - 1e-3;
        if (gap > NEAR) {
          room = Math.min(room, gap);
          continue;
        }
      }
      this.mobile[moving++] = i;
      this.disturb(i);
      fastest = Math.max(fastest, Math.abs(itsVX) + Math.abs(itsVY));
      // upper bound of how fast they approach each other: either may stop at any time
      const hers = vx * dx + vy * dy;
      const its = -(itsVX * dx + itsVY * dy);
      const speed = ((hers > 0 ? hers : 0) + (its > 0 ? its : 0)) / d;
      time = Math.min(time, (d - reach - 1e-2) / (speed + haste));
    }
    if (moving === 0) {
      this.calmX = x;
      this.calmY = y;
      this.calm = room;
    } else {
      this.calm = -1;
      this.moving = moving;
      // beyond that the speed limit may act at once
      if (!(time > 0) || fastest > this.fast) this.ahead = 0;
      else this.ahead = Math.min(Math.floor(time * TICK_RATE), this.apart(frame) - frame);
    }
    this.room = room;
  }

  /** The first frame in which two of them may touch. */
  private apart(frame: number): number {
    if (frame < this.apartUntil) return this.apartUntil;
    const { s, r, count, restless, apartHaste } = this;
    let time = APART_FRAMES * DT;
    this.budget.look((restless.length * count) >> 3);
    for (const i of restless) {
      const a = this.offset + CHASER_SIZE * i;
      if (s[a + 6] >= FUSE) continue;
      for (let j = 0; j < count; j++) {
        const b = this.offset + CHASER_SIZE * j;
        if (s[b + 6] >= FUSE || j === i) continue;
        const dx = s[b] - s[a];
        const dy = s[b + 1] - s[a + 1];
        const d = Math.sqrt(dx * dx + dy * dy);
        const one = s[a + 2] * dx + s[a + 3] * dy;
        const other = -(s[b + 2] * dx + s[b + 3] * dy);
        const speed = ((one > 0 ? one : 0) + (other > 0 ? other : 0)) / d;
        time = Math.min(time, (d - r[i] - r[j] - 1e-2) / (speed + apartHaste));
      }
    }
    this.apartUntil = time > 0 ? frame + Math.floor(time * TICK_RATE) : frame;
    return this.apartUntil;
  }

  /** Explodes pairs that touch. */
  explode(frame: number, recorder: FrameRecorder | null): void {
    if (frame === 0) {
      const { explosions } = this.circles;
      for (let k = 0; k < explosions.length; k += 2) this.ignite(frame, explosions[k], explosions[k + 1], recorder);
      this.forgetRestless();
      return;
    }
    if (frame < this.apart(frame)) return;
    const { s, r, count, restless } = this;
    const touching: [number, number][] = [];
    this.budget.look((restless.length * count) >> 3);
    for (const i of restless) {
      const a = this.offset + CHASER_SIZE * i;
      if (s[a + 6] >= FUSE) continue;
      for (let j = 0; j < count; j++) {
        const b = this.offset + CHASER_SIZE * j;
        // a pair of restless ones is reported once
        if (s[b + 6] >= FUSE || j === i || (j < i && this.isRestless[j] === 1)) continue;
        if (circlesOverlap(s[a] - s[b], s[a + 1] - s[b + 1], r[i] + r[j])) touching.push(i < j ? [i, j] : [j, i]);
      }
    }
    // in the order of the list: an exploded one does not explode again
    touching.sort((one, other) => one[0] - other[0] || one[1] - other[1]);
    for (const [i, j] of touching) {
      if (s[this.offset + CHASER_SIZE * i + 6] < FUSE && s[this.offset + CHASER_SIZE * j + 6] < FUSE)
        this.ignite(frame, i, j, recorder);
    }
    this.forgetRestless();
  }

  private ignite(frame: number, i: number, j: number, recorder: FrameRecorder | null): void {
    const { s } = this;
    s[this.offset + CHASER_SIZE * i + 6] = FUSE + frame + EXPLOSION_FRAMES;
    s[this.offset + CHASER_SIZE * j + 6] = FUSE + frame + EXPLOSION_FRAMES;
    if (recorder !== null) recorder.explosion(frame, i, j);
  }

  /**
   * Makes the frames that {@link lookAhead} examined: the moving ones chase her.
   * @param path - her place at the start of each frame, x and y alternately
   */
  follow(path: Float64Array, from: number, frames: number): void {
    const { s, mobile, moving, pull, sight, speedLimit } = this;
    for (let k = 0; k < moving; k++) {
      const o = this.offset + CHASER_SIZE * mobile[k];
      let x = s[o];
      let y = s[o + 1];
      let vx = s[o + 2];
      let vy = s[o + 3];
      let ax = s[o + 4];
      let ay = s[o + 5];
      const state = s[o + 6];
      const exploded = state >= FUSE;
      const stop = exploded ? state - FUSE - from : frames;
      let awake = false;
      let roused = !(vx === 0 && vy === 0 && ax === 0 && ay === 0);
      for (let n = 0; n < frames; n++) {
        vx = limitSpeed(vx + ax * DT, speedLimit);
        vy = limitSpeed(vy + ay * DT, speedLimit);
        // they do not touch, so the distance is not 0
        const dx = path[2 * n] - x;
        const dy = path[2 * n + 1] - y;
        const d = Math.sqrt(dx * dx + dy * dy);
        x += vx * DT;
        y += vy * DT;
        awake = d < sight && n < stop;
        if (awake) {
          ax = (pull * dx) / d;
          ay = (pull * dy) / d;
          roused = true;
        } else {
          vx = 0;
          vy = 0;
          ax = 0;
          ay = 0;
        }
      }
      s[o] = x;
      s[o + 1] = y;
      s[o + 2] = vx;
      s[o + 3] = vy;
      s[o + 4] = ax;
      s[o + 5] = ay;
      if (!exploded) s[o + 6] = awake ? AWAKE : ASLEEP;
      if (roused) s[ROUSED] = 1;
    }
  }

  /**
   * Updates velocities, then accelerations for the next frame, then places. An exploded chaser goes on until its fuse has burned
   * down, and one that stops still makes this frame's move, as in the original game.
   * @returns index of the first that touched her before, or -1
   */
  move(frame: number, recorder: FrameRecorder | null): number {
    const { s, r, count, box, pull, sight, speedLimit } = this;
    const x = s[X];
    const y = s[Y];
    let touching = -1;
    for (let i = 0; i < count; i++) {
      const o = this.offset + CHASER_SIZE * i;
      const vx = limitSpeed(s[o + 2] + s[o + 4] * DT, speedLimit);
      const vy = limitSpeed(s[o + 3] + s[o + 5] * DT, speedLimit);
      const dx = x - s[o];
      const dy = y - s[o + 1];
      const d = Math.sqrt(dx * dx + dy * dy);
      if (touching < 0 && d < r[i] + box.halfDiagonal + 1 && boxOverlapsCircle(box, -dx, -dy, s[COS], s[SIN], r[i])) touching = i;
      const state = s[o + 6];
      const exploded = state >= FUSE;
      const awake = d < sight && !(exploded && frame >= state - FUSE);
      s[o] += vx * DT;
      s[o + 1] += vy * DT;
      if (awake) {
        s[o + 2] = vx;
        s[o + 3] = vy;
        s[o + 4] = d > 0 ? (pull * dx) / d : pull;
        s[o + 5] = d > 0 ? (pull * dy) / d : 0;
      } else {
        s[o + 2] = 0;
        s[o + 3] = 0;
        s[o + 4] = 0;
        s[o + 5] = 0;
      }
      if (awake || vx !== 0 || vy !== 0) {
        s[ROUSED] = 1;
        this.calm = -1;
        this.disturb(i);
      }
      if (exploded || awake === (state === AWAKE)) continue;
      s[o + 6] = awake ? AWAKE : ASLEEP;
      if (recorder !== null) recorder.alertness(frame, i, awake);
    }
    return touching;
  }

  read(out: Float64Array): void {
    const { s } = this;
    for (let i = 0; i < this.count; i++) {
      const o = this.offset + CHASER_SIZE * i;
      out[3 * i] = s[o];
      out[3 * i + 1] = s[o + 1];
      out[3 * i + 2] = s[o + 6] < FUSE ? 1 : 0;
    }
  }
}

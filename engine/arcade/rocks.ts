import { TICK } from '../constants.ts';
import type { Scene } from '../scene.ts';
import { HEAD, limitSpeed, MOVED, STRAYED } from './layout.ts';
import { DRIFT } from './neighbourhoods.ts';

/** Doubles per asteroid: place, velocity in the next frame, acceleration. */
export const ROCK = 6;

/** Frames that may pass before {@link Rocks.move} checks again whether an asteroid has strayed. */
export const ROCK_FRAMES = 32;

/** An asteroid that has not strayed moves at most this far in {@link ROCK_FRAMES} frames, px. */
export const ROCK_LEEWAY = 3;

/**
 * An asteroid has strayed from this distance (px) or speed (px/s) on. Below both it cannot get {@link DRIFT} px away within
 * {@link ROCK_FRAMES} more frames, since recoil is weaker than `STRONG`.
 */
const STRAY = DRIFT - ROCK_LEEWAY;
const FAST = 4;
const STRONG = 4;

const DT = TICK; // V8 folds constants of the same module

/** Asteroids under recoil. Those that have been pulled once move, each on its own. */
export class Rocks {
  /** Index in the state of the list of those that move. */
  private readonly list: number;
  /** Index in the state behind the asteroids. */
  readonly end: number;
  // their original places, px
  private readonly homeX: Float64Array;
  private readonly homeY: Float64Array;
  /** Upper bound of recoil in the level, px/s², both axes together. */
  private readonly strongest: number;
  private readonly speedLimit: number;

  constructor(
    private readonly s: Float64Array,
    private readonly scene: Scene,
  ) {
    const count = scene.level.recoil ? scene.targets.count : 0;
    this.list = HEAD + ROCK * count;
    this.end = this.list + count;
    this.homeX = scene.targets.x;
    this.homeY = scene.targets.y;
    this.speedLimit = scene.rules.speedLimit;
    let smallest = Number.POSITIVE_INFINITY;
    for (let i = 0; i < count; i++) smallest = Math.min(smallest, scene.targets.r[i]);
    this.strongest = scene.rules.recoil / smallest; // twice 1 / diameter: both axes together are at most sqrt(2) times that
  }

  layOut(s: Float64Array): void {
    const { targets } = this.scene;
    if (!this.scene.level.recoil) return;
    for (let i = 0; i < targets.count; i++) {
      const o = HEAD + ROCK * i;
      // adding 0 turns -0 into 0, as moving by 0 would
      s[o] = targets.x[i] + 0;
      s[o + 1] = targets.y[i] + 0;
      if (targets.r[i] * 2 * STRONG < this.scene.rules.recoil) s[STRAYED] = 1;
    }
  }

  /** Adds an asteroid to those that move. */
  stir(i: number): void {
    const { s, list } = this;
    const count = s[MOVED];
    for (let k = 0; k < count; k++) if (s[list + k] === i) return;
    s[list + count] = i;
    s[MOVED] = count + 1;
  }

  /** How far any of them may move in {@link ROCK_FRAMES} frames, px, once one has strayed. */
  leeway(): number {
    const { s, list } = this;
    const time = ROCK_FRAMES * DT;
    const count = s[MOVED];
    let fastest = 0;
    for (let k = 0; k < count; k++) {
      const o = HEAD + ROCK * s[list + k];
      fastest = Math.max(fastest, Math.abs(s[o + 2]) + Math.abs(s[o + 3]));
    }
    return (fastest + this.strongest * time) * time + 1e-3;
  }

  /** Whether an asteroid may reach the speed limit within {@link ROCK_FRAMES} frames. */
  isFast(i: number): boolean {
    const { s } = this;
    const o = HEAD + ROCK * i;
    return Math.abs(s[o + 2]) + Math.abs(s[o + 3]) + this.strongest * ROCK_FRAMES * DT > this.speedLimit / 2;
  }

  /**
   * Makes the moves of at most {@link ROCK_FRAMES} frames in which no acceleration changes.
   * @param but - an asteroid that is not moved, or -1
   */
  move(frames: number, but: number): void {
    const { s, list, speedLimit } = this;
    const count = s[MOVED];
    for (let k = 0; k < count; k++) {
      const i = s[list + k];
      if (i === but) continue;
      const o = HEAD + ROCK * i;
      const ax = s[o + 4] * DT;
      const ay = s[o + 5] * DT;
      let x = s[o];
      let y = s[o + 1];
      let vx = s[o + 2];
      let vy = s[o + 3];
      if (ax === 0 && ay === 0) {
        const moveX = vx * DT;
        const moveY = vy * DT;
        for (let n = 0; n < frames; n++) {
          x += moveX;
          y += moveY;
        }
      } else {
        for (let n = 0; n < frames; n++) {
          x += vx * DT;
          y += vy * DT;
          vx = limitSpeed(vx + ax, speedLimit);
          vy = limitSpeed(vy + ay, speedLimit);
        }
      }
      s[o] = x;
      s[o + 1] = y;
      s[o + 2] = vx;
      s[o + 3] = vy;
      this.watch(i);
    }
  }

  /** Makes the moves of one frame; {@link watchAll} is due after {@link ROCK_FRAMES} of them. */
  step(): void {
    const { s, list, speedLimit } = this;
    const end = list + s[MOVED];
    for (let k = list; k < end; k++) {
      const o = HEAD + ROCK * s[k];
      const vx = s[o + 2];
      const vy = s[o + 3];
      s[o] += vx * DT;
      s[o + 1] += vy * DT;
      s[o + 2] = limitSpeed(vx + s[o + 4] * DT, speedLimit);
      s[o + 3] = limitSpeed(vy + s[o + 5] * DT, speedLimit);
    }
  }

  /** Checks whether any asteroid has strayed. */
  watchAll(): void {
    const { s, list } = this;
    const end = list + s[MOVED];
    for (let k = list; k < end; k++) this.watch(s[k]);
  }

  /** Checks whether an asteroid has strayed. */
  watch(i: number): void {
    const { s, homeX, homeY } = this;
    const o = HEAD + ROCK * i;
    if (Math.abs(s[o] - homeX[i]) + Math.abs(s[o + 1] - homeY[i]) > STRAY || Math.abs(s[o + 2]) + Math.abs(s[o + 3]) > FAST) {
      s[STRAYED] = 1;
    }
  }
}

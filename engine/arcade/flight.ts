import { TICK } from '../constants.ts';
import { AHEAD } from './chasers.ts';
import { AX, AY, COS, FRAME, HEAD, limitSpeed, MOVED, SIN, VX, VY, X, Y } from './layout.ts';
import { ROCK, ROCK_FRAMES } from './rocks.ts';
import type { Surroundings } from './surroundings.ts';
import { NUMBERS, type World } from './world.ts';

// V8 folds constants of the same module, but loads imported ones
const DT = TICK;
const { PULL, RECOIL, LIMIT } = NUMBERS;

const NOWHERE = new Float64Array(0);

/** Frames away from objects: only the gun acts while she stays within the bounds of her surroundings. */
export class Flight {
  /** Her place at the start of each frame, x and y alternately, if it was traced. */
  readonly path: Float64Array;

  constructor(
    private readonly world: World,
    private readonly around: Surroundings,
  ) {
    // only chasers follow it
    this.path = world.chasers.count > 0 ? new Float64Array(2 * AHEAD) : NOWHERE;
  }

  /**
   * Makes frames until she leaves the bounds.
   * @param until - the frame to stop at
   * @param traced - whether to keep her path, at most {@link AHEAD} frames of it
   */
  fly(until: number, held: boolean, traced: boolean): void {
    const { rivals } = this.around;
    const { recoil, rocks } = this.world;
    if (!held && (!recoil || this.lettingGoIsOver(rivals))) this.coast(until, traced);
    else if (held && rivals.length === 1 && !(recoil && rocks.isFast(rivals[0]))) this.pull(rivals[0], until, traced);
    else this.swing(rivals, until, held, traced);
  }

  /**
   * With the button up: whether no asteroid that may be the nearest has an acceleration left to be cleared. A single one has
   * none.
   */
  private lettingGoIsOver(rivals: Int32Array): boolean {
    const { s } = this.world;
    if (s[MOVED] === 0) return true;
    for (let k = 0; k < rivals.length; k++) {
      const o = HEAD + ROCK * rivals[k];
      if (s[o + 4] === 0 && s[o + 5] === 0) continue;
      if (rivals.length > 1) return false;
      s[o + 4] = 0;
      s[o + 5] = 0;
    }
    return true;
  }

  /** Frames without the gun. */
  private coast(until: number, traced: boolean): void {
    const { path } = this;
    const { s, rocks, numbers } = this.world;
    const speedLimit = numbers[LIMIT];
    const { bounds } = this.around;
    const left = bounds[0];
    const right = bounds[1];
    const top = bounds[2];
    const bottom = bounds[3];
    const from = s[FRAME];
    const moved = s[MOVED] > 0;
    const limit = moved ? Math.min(until, from + ROCK_FRAMES) : until;
    if (traced) {
      path[0] = s[X];
      path[1] = s[Y];
    }
    // what the gun did in the previous frame still counts in the first
    let vx = limitSpeed(s[VX] + s[AX] * DT, speedLimit);
    let vy = limitSpeed(s[VY] + s[AY] * DT, speedLimit);
    let x = s[X] + vx * DT;
    let y = s[Y] + vy * DT;
    let frame = from + 1;
    if (frame < limit && x >= left && x < right && y >= top && y < bottom) {
      // adding no acceleration turns -0 into 0
      vx += 0;
      vy += 0;
      const moveX = vx * DT;
      const moveY = vy * DT;
      do {
        if (traced) {
          path[2 * (frame - from)] = x;
          path[2 * (frame - from) + 1] = y;
        }
        x += moveX;
        y += moveY;
        frame++;
      } while (frame < limit && x >= left && x < right && y >= top && y < bottom);
    }
    s[FRAME] = frame;
    s[X] = x;
    s[Y] = y;
    s[VX] = vx;
    s[VY] = vy;
    s[AX] = 0;
    s[AY] = 0;
    if (moved) rocks.move(frame - from, -1);
  }

  /** Frames with the gun and a single possible target. */
  private pull(target: number, until: number, traced: boolean): void {
    const { path } = this;
    const { s, range, targetR, recoil, rocks, numbers, places, placesFrom, placesStep } = this.world;
    const pull = numbers[PULL];
    const kickback = numbers[RECOIL];
    const speedLimit = numbers[LIMIT];
    const { bounds } = this.around;
    const left = bounds[0];
    const right = bounds[1];
    const top = bounds[2];
    const bottom = bounds[3];
    const o = placesFrom + placesStep * target;
    const kick = -kickback / (2 * targetR[target]);
    const from = s[FRAME];
    const limit = recoil ? Math.min(until, from + ROCK_FRAMES) : until;
    let rockX = places[o];
    let rockY = places[o + 1];
    let rockVX = recoil ? s[o + 2] : 0;
    let rockVY = recoil ? s[o + 3] : 0;
    let frame = from;
    let x = s[X];
    let y = s[Y];
    let vx = s[VX];
    let vy = s[VY];
    let ax = s[AX];
    let ay = s[AY];
    let cos = 1;
    let sin = 0;
    do {
      if (traced) {
        path[2 * (frame - from)] = x;
        path[2 * (frame - from) + 1] = y;
      }
      vx = limitSpeed(vx + ax * DT, speedLimit);
      vy = limitSpeed(vy + ay * DT, speedLimit);
      const dx = rockX - x;
      const dy = rockY - y;
      const d = Math.sqrt(dx * dx + dy * dy);
      // atan2(0, 0) is 0 in the original: at the very centre she turns to angle 0 and is pulled in that direction
      cos = d > 0 ? dx / d : 1;
      sin = d > 0 ? dy / d : 0;
      const strength = pull * (1 - d / range);
      ax = strength * cos;
      ay = strength * sin;
      if (recoil) {
        rockX += rockVX * DT;
        rockY += rockVY * DT;
        rockVX += kick * cos * DT;
        rockVY += kick * sin * DT;
      }
      x += vx * DT;
      y += vy * DT;
      frame++;
    } while (frame < limit && x >= left && x < right && y >= top && y < bottom);
    s[FRAME] = frame;
    s[X] = x;
    s[Y] = y;
    s[VX] = vx;
    s[VY] = vy;
    s[AX] = ax;
    s[AY] = ay;
    s[COS] = cos;
    s[SIN] = sin;
    if (!recoil) return;
    s[o] = rockX;
    s[o + 1] = rockY;
    s[o + 2] = rockVX;
    s[o + 3] = rockVY;
    s[o + 4] = kick * cos;
    s[o + 5] = kick * sin;
    rocks.stir(target);
    rocks.watch(target);
    rocks.move(frame - from, target);
  }

  /** Frames with the gun where several asteroids may be the nearest, or with asteroids whose acceleration is to be cleared. */
  private swing(rivals: Int32Array, until: number, held: boolean, traced: boolean): void {
    const { path } = this;
    const { s, range, targetR, recoil, rocks, numbers, places, placesFrom, placesStep } = this.world;
    const pull = numbers[PULL];
    const kickback = numbers[RECOIL];
    const speedLimit = numbers[LIMIT];
    const { bounds } = this.around;
    const left = bounds[0];
    const right = bounds[1];
    const top = bounds[2];
    const bottom = bounds[3];
    const count = rivals.length;
    const from = s[FRAME];
    const limit = recoil ? Math.min(until, from + ROCK_FRAMES) : until;
    let frame = from;
    let x = s[X];
    let y = s[Y];
    let vx = s[VX];
    let vy = s[VY];
    let ax = s[AX];
    let ay = s[AY];
    let cos = s[COS];
    let sin = s[SIN];
    let stirred = -1;
    do {
      if (traced) {
        path[2 * (frame - from)] = x;
        path[2 * (frame - from) + 1] = y;
      }
      vx = limitSpeed(vx + ax * DT, speedLimit);
      vy = limitSpeed(vy + ay * DT, speedLimit);
      let nearest = rivals[0];
      let o = placesFrom + placesStep * nearest;
      let dx = places[o] - x;
      let dy = places[o + 1] - y;
      let best = dx * dx + dy * dy;
      for (let k = 1; k < count; k++) {
        const other = placesFrom + placesStep * rivals[k];
        const ex = places[other] - x;
        const ey = places[other + 1] - y;
        const d2 = ex * ex + ey * ey;
        if (d2 < best) {
          best = d2;
          dx = ex;
          dy = ey;
          nearest = rivals[k];
          o = other;
        }
      }
      if (held) {
        const d = Math.sqrt(best);
        // as in `pull`
        cos = d > 0 ? dx / d : 1;
        sin = d > 0 ? dy / d : 0;
        const strength = pull * (1 - d / range);
        ax = strength * cos;
        ay = strength * sin;
      } else {
        ax = 0;
        ay = 0;
      }
      if (recoil) {
        if (held) {
          const a = kickback / (2 * targetR[nearest]);
          s[o + 4] = -a * cos;
          s[o + 5] = -a * sin;
          if (nearest !== stirred) rocks.stir(nearest);
          stirred = nearest;
        } else {
          s[o + 4] = 0;
          s[o + 5] = 0;
        }
        rocks.step();
      }
      x += vx * DT;
      y += vy * DT;
      frame++;
    } while (frame < limit && x >= left && x < right && y >= top && y < bottom);
    s[FRAME] = frame;
    s[X] = x;
    s[Y] = y;
    s[VX] = vx;
    s[VY] = vy;
    s[AX] = ax;
    s[AY] = ay;
    s[COS] = cos;
    s[SIN] = sin;
    if (recoil) rocks.watchAll();
  }
}

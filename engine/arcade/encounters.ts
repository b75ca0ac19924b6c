import { TICK } from '../constants.ts';
import { boxOverlapsCircle } from '../contact.ts';
import type { Frame } from '../frames.ts';
import type { RunEvent, Simulation } from '../simulation.ts';
import {
  AX,
  AY,
  BLACK_HOLE,
  COLLIDED,
  COS,
  COUNTED,
  FRAME,
  HEAD,
  LOST,
  limitSpeed,
  OUTCOME,
  SIN,
  TOUCHED,
  VX,
  VY,
  X,
  Y,
} from './layout.ts';
import type { Neighbourhood } from './neighbourhoods.ts';
import type { FrameRecorder } from './recording.ts';
import { ROCK } from './rocks.ts';
import { NUMBERS, type World } from './world.ts';

// V8 folds constants of the same module, but loads imported ones
const DT = TICK;
const { PULL, RECOIL, LIMIT } = NUMBERS;

/** Frames among objects that are made before it is examined again whether objects are near. */
const FRAMES_AMONG = 6;
const FRAMES_ALERT = 12;

/** Frames in which everything in her neighbourhood is examined, in the order of the original game. */
export class Encounters {
  private readonly body: Frame;

  constructor(
    private readonly simulation: Simulation,
    private readonly world: World,
    private readonly recorder: FrameRecorder | null,
  ) {
    const tell = recorder === null ? null : (event: RunEvent) => recorder.event(event);
    this.body = { scene: world.scene, s: world.s, number: 0, x: 0, y: 0, ax: 0, ay: 0, tell };
  }

  /**
   * Makes some frames among objects; stops where she leaves the bounds or the run ends.
   * @param bounds - left, right, top and bottom within which the neighbourhood holds, px
   * @param alert - whether a chaser matters
   */
  meet(cell: Neighbourhood, bounds: Float64Array, until: number, held: boolean, alert: boolean): void {
    const { recorder } = this;
    const {
      s,
      range,
      targetR,
      recoil,
      rocks,
      chasers,
      places,
      placesFrom,
      placesStep,
      deadlyX,
      deadlyY,
      deadlyR,
      firstTarget,
      box,
      numbers,
      frameRules,
      frameStates,
    } = this.world;
    const pull = numbers[PULL];
    const kickback = numbers[RECOIL];
    const speedLimit = numbers[LIMIT];
    const left = bounds[0];
    const right = bounds[1];
    const top = bounds[2];
    const bottom = bounds[3];
    const { rivals, deadly, discs } = cell;
    const near = cell.collectables;
    const rangeSquared = range * range;
    const limit = Math.min(until, s[FRAME] + (alert ? FRAMES_ALERT : FRAMES_AMONG));
    let frame = s[FRAME];
    let x = s[X];
    let y = s[Y];
    let vx = s[VX];
    let vy = s[VY];
    let ax = s[AX];
    let ay = s[AY];
    let cos = s[COS];
    let sin = s[SIN];
    do {
      // velocities and displacements; places stay those of the previous frame until the end of the frame
      vx = limitSpeed(vx + ax * DT, speedLimit);
      vy = limitSpeed(vy + ay * DT, speedLimit);
      const moveX = vx * DT;
      const moveY = vy * DT;

      // the nearest asteroid; the first of equally near ones
      let best = Number.POSITIVE_INFINITY;
      let nearest = -1;
      for (let k = 0; k < rivals.length; k++) {
        const o = placesFrom + placesStep * rivals[k];
        const dx = places[o] - x;
        const dy = places[o + 1] - y;
        const d2 = dx * dx + dy * dy;
        if (d2 < best) {
          best = d2;
          nearest = rivals[k];
        }
      }
      if (best > rangeSquared) s[OUTCOME] = LOST;

      if (held && nearest >= 0) {
        const o = placesFrom + placesStep * nearest;
        const d = Math.sqrt(best);
        // atan2(0, 0) is 0 in the original: at the very centre she turns to angle 0 and is pulled in that direction
        cos = d > 0 ? (places[o] - x) / d : 1;
        sin = d > 0 ? (places[o + 1] - y) / d : 0;
        s[COS] = cos;
        s[SIN] = sin;
        const strength = pull * (1 - d / range);
        ax = strength * cos;
        ay = strength * sin;
        if (recoil) {
          const a = kickback / (2 * targetR[nearest]);
          s[o + 4] = -a * cos;
          s[o + 5] = -a * sin;
          rocks.stir(nearest);
        }
      } else {
        ax = 0;
        ay = 0;
        if (recoil && nearest >= 0) {
          const o = HEAD + ROCK * nearest;
          s[o + 4] = 0;
          s[o + 5] = 0;
        }
      }
      if (recorder !== null) recorder.button(s, frame, held, nearest);

      // the checks, in the order of the original
      const going = s[OUTCOME] === 0;
      if (going) {
        for (let k = 0; k < deadly.length; k++) {
          const code = deadly[k];
          const o = placesFrom + placesStep * (code - firstTarget);
          const moves = recoil && code >= firstTarget;
          const dx = (moves ? places[o] : deadlyX[code]) - x;
          const dy = (moves ? places[o + 1] : deadlyY[code]) - y;
          if (!boxOverlapsCircle(box, dx, dy, cos, sin, deadlyR[code])) continue;
          this.touch(code);
          break;
        }
        if (near.length > 0) this.collect(near);
        if (alert) chasers.explode(frame, recorder);
      }
      if (alert) {
        const chaser = chasers.move(frame, recorder);
        if (chaser >= 0 && going && s[OUTCOME] === 0) this.end(this.world.caught, chasers.circles.index[chaser]);
      }

      if (frameRules.length > 0) {
        const { body } = this;
        body.number = frame;
        body.x = x;
        body.y = y;
        body.ax = ax;
        body.ay = ay;
        for (let k = 0; k < frameRules.length; k++) frameRules[k].act(body, discs[k], frameStates[k]);
        x = body.x;
        y = body.y;
        ax = body.ax;
        ay = body.ay;
      }
      if (s[OUTCOME] >= COLLIDED) {
        vx = 0;
        vy = 0;
      }
      x += moveX;
      y += moveY;
      s[X] = x;
      s[Y] = y;
      if (recoil) rocks.step();
      frame++;
      if (recorder !== null) {
        s[FRAME] = frame;
        s[VX] = vx;
        s[VY] = vy;
        this.record(recorder, frame - 1);
      }
    } while (frame < limit && s[OUTCOME] === 0 && x >= left && x < right && y >= top && y < bottom);
    s[FRAME] = frame;
    s[VX] = vx;
    s[VY] = vy;
    s[AX] = ax;
    s[AY] = ay;
    if (recoil) rocks.watchAll();
  }

  private record(recorder: FrameRecorder, frame: number): void {
    const outcome = this.world.s[OUTCOME];
    recorder.row(this.simulation);
    if (outcome === 0) return;
    recorder.end(
      frame,
      outcome === LOST ? 'lost' : outcome === BLACK_HOLE ? 'completed' : 'collided',
      this.world.kindTouched(outcome),
      this.world.s[TOUCHED],
    );
  }

  private end(outcome: number, touched: number): void {
    this.world.s[OUTCOME] = outcome;
    this.world.s[TOUCHED] = touched;
  }

  /** She touches the black hole or a hazard. */
  private touch(code: number): void {
    if (code === 0) this.end(BLACK_HOLE, 0);
    for (const { from, outcome, circles } of this.world.deadly) {
      if (code >= from && code < from + circles.count) this.end(outcome, circles.index[code - from]);
    }
  }

  /** Of several things touched in one frame all are counted, but only the last is removed, as in the original game. */
  private collect(near: Int32Array): void {
    const { recorder } = this;
    const { s, box, collected, collectableX, collectableY, collectableR } = this.world;
    let last = -1;
    for (let k = 0; k < near.length; k++) {
      const i = near[k];
      if (s[collected + i] !== 0) continue;
      if (!boxOverlapsCircle(box, collectableX[i] - s[X], collectableY[i] - s[Y], s[COS], s[SIN], collectableR[i])) continue;
      s[COUNTED]++;
      last = i;
      if (recorder !== null) recorder.collected(s[FRAME], i);
    }
    if (last >= 0) s[collected + last] = 1;
  }
}

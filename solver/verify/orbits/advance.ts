import { leastProduct, leastSquare, mostProduct, mostSquare } from './arithmetic.ts';
import type { Forces } from './forces.ts';
import type { Places } from './places.ts';
import { ROUNDING, type Scene } from './scene.ts';

/** Far more than the rounding error of one step: angles, rad, and angular momentum, px²/s. */
const OF_ANGLE = 1e-8;
const OF_MOMENTUM = 1e-5;

/** What of its distance must remain in any case of a box in polar coordinates. */
const LEAST_SHARE = 0.1;

/** A step in polar coordinates is made in parts, each of which takes her nearer by an eighth of her distance or little more. */
const SHARE_OF_PART = 8;

/** Length of a part of a step in x and y, s. */
const PART_NEAR = 0.05;

/** The most parts of a step. */
const MOST_PARTS = 64;

/**
 * Advances boxes by one step. With y as her place relative to the asteroid, d as her distance, w as its rate and L as angular
 * momentum, exactly
 *
 *   d' = w,  w' = L² / d³ + (acceleration away from the asteroid),  angle' = L / d²,  L' = d (acceleration across).
 *
 * Every bound holds for accelerations that vary at will within their bounds. Where distances lie above d0 + t W for all t, the
 * integrals of 1 / d² and 1 / d³ over the step are at most those of this line, which are known in closed form.
 */
export class Stepper {
  /** The places of the last step, or part of one, that was made. */
  readonly places: Places;
  private readonly scene: Scene;
  private readonly forces: Forces;

  constructor(scene: Scene, places: Places, forces: Forces) {
    this.scene = scene;
    this.places = places;
    this.forces = forces;
  }

  /**
   * Advances a box in polar coordinates: distance, angle, rate of distance, angular momentum. `isSafe` is asked about the
   * places of the step. Returns whether it agreed; false as well if she may come too near to the centre for these coordinates.
   */
  polar(i: number, box: Float64Array, isSafe: (chart: number) => boolean): boolean {
    const { seconds, push } = this.scene;
    const fastest = Math.sqrt(mostSquare(box[4], box[5]) + mostSquare(box[6], box[7]) / (box[0] * box[0]));
    const flight = seconds * (fastest + push * seconds);
    const parts = Math.min(MOST_PARTS, Math.max(1, Math.ceil((SHARE_OF_PART * flight) / box[0])));
    for (let n = 0; n < parts; n++) if (!this.partPolar(i, box, seconds / parts, isSafe)) return false;
    return true;
  }

  private partPolar(i: number, box: Float64Array, h: number, isSafe: (chart: number) => boolean): boolean {
    const { scene, places, forces } = this;
    const a = scene.push;
    const d0 = box[0];
    const d1 = box[1];
    const w0 = box[4];
    const w1 = box[5];
    const L0 = box[6];
    const L1 = box[7];
    const fastest = Math.sqrt(mostSquare(w0, w1) + mostSquare(L0, L1) / (d0 * d0));
    const flight = fastest * h + (a * h * h) / 2;
    let least = d0 - flight;
    let most = d1 + flight;
    if (!(least >= LEAST_SHARE * d0)) return false;
    // First with any acceleration, then with those that are possible where she is.
    let lowest = leastSquare(L0 - a * most * h, L1 + a * most * h);
    let highest = mostSquare(L0 - a * most * h, L1 + a * most * h);
    let slow = w0 + h * Math.min(0, lowest / cube(most) - a);
    let fast = w1 + h * (highest / cube(least) + a);
    least = d0 + h * Math.min(0, slow);
    most = d1 + h * Math.max(0, fast);
    if (!(least >= LEAST_SHARE * d0)) return false;
    const spin = h / (least * least);
    const drag = a * most * h;
    places.sector(least, most, box[2] + spin * Math.min(0, L0 - drag), box[3] + spin * Math.max(0, L1 + drag));
    forces.look(i);
    const { all } = forces;
    const torque0 = forces.isCentral ? 0 : Math.min(all.b0 * least, all.b0 * most);
    const torque1 = forces.isCentral ? 0 : Math.max(all.b1 * least, all.b1 * most);
    const M0 = L0 + h * Math.min(0, torque0);
    const M1 = L1 + h * Math.max(0, torque1);
    lowest = leastSquare(M0, M1);
    highest = mostSquare(M0, M1);
    slow = w0 + h * Math.min(0, lowest / cube(most) + all.a0);
    fast = w1 + h * Math.max(0, highest / cube(least) + all.a1);
    const e0 = d0 + h * slow;
    const e1 = d1 + h * fast;
    if (!(e0 > 0)) return false;
    least = Math.min(d0, e0);
    most = Math.max(d1, e1);
    const turn0 = M0 > 0 ? (M0 * h) / (d1 * e1) : (M0 * h) / (d0 * e0);
    const turn1 = M1 > 0 ? (M1 * h) / (d0 * e0) : (M1 * h) / (d1 * e1);
    places.sector(least, most, box[2] + Math.min(0, turn0), box[3] + Math.max(0, turn1));
    if (!isSafe(i)) return false;
    const outward0 = (lowest * h * (d1 + e1)) / (2 * d1 * d1 * e1 * e1);
    const outward1 = (highest * h * (d0 + e0)) / (2 * d0 * d0 * e0 * e0);
    const half = (h * h) / 2;
    box[0] = d0 + h * w0 + half * (all.a0 + outwards(lowest, d0 + h * Math.max(0, fast), most, least, half)) - ROUNDING;
    box[1] = d1 + h * w1 + half * (all.a1 + outwards(highest, d1 + h * Math.min(0, slow), least, least, half)) + ROUNDING;
    box[2] += turn0 - OF_ANGLE;
    box[3] += turn1 + OF_ANGLE;
    box[4] = w0 + h * all.a0 + outward0 - ROUNDING;
    box[5] = w1 + h * all.a1 + outward1 + ROUNDING;
    box[6] = L0 + h * torque0 - OF_MOMENTUM;
    box[7] = L1 + h * torque1 + OF_MOMENTUM;
    return true;
  }

  /** Advances a box in x and y, with velocities and the angular momentum; false when `isSafe` does not agree. */
  near(i: number, box: Float64Array, isSafe: (chart: number) => boolean): boolean {
    const { seconds } = this.scene;
    // On the way past the centre the pull turns, so it is known better in short parts.
    const parts = Math.max(1, Math.ceil(seconds / PART_NEAR - 1e-9));
    for (let n = 0; n < parts; n++) if (!this.partNear(i, box, seconds / parts, isSafe)) return false;
    return true;
  }

  private partNear(i: number, box: Float64Array, h: number, isSafe: (chart: number) => boolean): boolean {
    const { places, forces, scene } = this;
    const half = (h * h) / 2;
    const x0 = box[0];
    const x1 = box[1];
    const y0 = box[2];
    const y1 = box[3];
    const left = x0 + h * Math.min(0, box[4]);
    const right = x1 + h * Math.max(0, box[5]);
    const low = y0 + h * Math.min(0, box[6]);
    const high = y1 + h * Math.max(0, box[7]);
    const bend = scene.push * half;
    places.rectangle(left - bend, right + bend, low - bend, high + bend);
    forces.look(i);
    const { all, others } = forces;
    places.rectangle(
      left + half * Math.min(0, all.a0),
      right + half * Math.max(0, all.a1),
      low + half * Math.min(0, all.b0),
      high + half * Math.max(0, all.b1),
    );
    if (!isSafe(i)) return false;
    if (!forces.isCentral) {
      // x times the acceleration along y, minus y times that along x
      const { x0: px0, x1: px1, y0: py0, y1: py1 } = places;
      const { a0, a1, b0, b1 } = others;
      box[8] += h * (leastProduct(px0, px1, b0, b1) - mostProduct(py0, py1, a0, a1));
      box[9] += h * (mostProduct(px0, px1, b0, b1) - leastProduct(py0, py1, a0, a1));
    }
    box[0] = x0 + h * box[4] + half * all.a0 - ROUNDING;
    box[1] = x1 + h * box[5] + half * all.a1 + ROUNDING;
    box[2] = y0 + h * box[6] + half * all.b0 - ROUNDING;
    box[3] = y1 + h * box[7] + half * all.b1 + ROUNDING;
    box[4] += h * all.a0 - ROUNDING;
    box[5] += h * all.a1 + ROUNDING;
    box[6] += h * all.b0 - ROUNDING;
    box[7] += h * all.b1 + ROUNDING;
    box[8] -= OF_MOMENTUM;
    box[9] += OF_MOMENTUM;
    return true;
  }
}

const cube = (d: number): number => d * d * d;

/**
 * A bound of L² / d³ on the ways that start at one end of a box and come to `there` at most. Ways that start elsewhere in the
 * box may have a less favourable one, but as long as this changes more slowly with the distance than the distance itself, those
 * at the end decide where the box ends. Otherwise, the bound is that of all places of the step, from `any`.
 */
function outwards(squared: number, there: number, any: number, least: number, half: number): number {
  const isSlow = 3 * half * squared < least * least * least * least;
  return squared / cube(isSlow ? there : any);
}

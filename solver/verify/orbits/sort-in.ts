import type { OrbitGrid } from '../../proofs/index.ts';
import { cosineAndSine } from './angles.ts';
import { Boxes, SIZE } from './boxes.ts';
import { Sight, Vector } from './convert.ts';
import { Places } from './places.ts';
import { ROUNDING, type Rock, type Scene } from './scene.ts';
import { OWN, Whereabouts } from './whereabouts.ts';

/** Nearer to an asteroid than this, px, boxes are in x and y; further away if she is fast. */
const CLOSE = 32;

/** The least distance for polar coordinates, as a share of how far she can go within a step. */
const SHARE = 0.25;

/** At rest nearer to a centre than this, px, the engine counts as in the centre. */
const IN_CENTRE = 1e-6;

/**
 * A box may extend beyond its cell by this share of the cell's size: angular momentum is preserved, and rounding alone must not
 * bring boxes into other cells.
 */
const OVERHANG = 0.01;

/** In the chart of asteroid i, boxes in polar coordinates have the number 2 i, those in x and y 2 i + 1. */
export const isNear = (chart: number): boolean => (chart & 1) === 1;
export const asteroidOf = (chart: number): number => chart >> 1;

/**
 * Cuts boxes along the grid, drops what has ended, and joins the rest to the boxes of a time. A piece stays in the chart of its
 * asteroid as long as this may be the nearest at one of its places, since the forces of all others are known in any chart.
 */
export class Sorter extends Whereabouts {
  /** The pieces that were looked at. */
  looked = 0;
  private readonly grid: OrbitGrid;
  private readonly most: number;
  private readonly turn: number;
  private readonly around: number;
  private boxes = new Boxes();
  private readonly target = new Places();
  private readonly piece = new Float64Array(SIZE);
  private readonly nearPiece = new Float64Array(SIZE);
  private readonly velocity = new Vector();
  private readonly turned = new Vector();
  private readonly sight = new Sight();
  private readonly axes = new Float64Array(2);
  private readonly made = new Float64Array(SIZE);
  /** A direction, and bounds of the velocity along it: what has other velocities is not in the box that is sorted in. */
  private readonly along = { x: 0, y: 0, least: 0, most: 0 };

  /**
   * @param most - the most pieces to look at; no more are put into the boxes
   */
  constructor(scene: Scene, grid: OrbitGrid, most: number) {
    super(scene);
    this.grid = grid;
    this.most = most;
    this.around = Math.round((2 * Math.PI * 100) / grid.place);
    this.turn = (2 * Math.PI) / this.around;
  }

  /** Puts everything that follows into these boxes, at this time, s. */
  into(boxes: Boxes, time: number): void {
    this.boxes = boxes;
    this.at(time);
  }

  /** Whether there are so many pieces that some were left out. */
  get isTooMuch(): boolean {
    return this.looked > this.most;
  }

  /** Counts the pieces into which something is cut; false when they are too many. */
  private mayLookAt(pieces: number): boolean {
    // not a number counts as too many
    this.looked = pieces >= 0 ? this.looked + pieces : Number.POSITIVE_INFINITY;
    return !this.isTooMuch;
  }

  /** Sorts in a box in polar coordinates. */
  polar(i: number, box: Float64Array): void {
    const { place } = this.grid;
    const { turn } = this;
    const [a0, a1] = [Math.floor(box[0] / place), Math.floor(box[1] / place)];
    const [b0, b1] = [Math.floor(box[2] / turn), Math.floor(box[3] / turn)];
    if (!this.mayLookAt((a1 - a0 + 1) * (b1 - b0 + 1))) return;
    for (let a = a0; a <= a1; a++) {
      const d0 = Math.max(box[0], a * place);
      const d1 = Math.min(box[1], (a + 1) * place);
      for (let b = b0; b <= b1; b++) {
        this.sector(
          i,
          a,
          b,
          d0,
          d1,
          Math.max(box[2], b * turn),
          Math.min(box[3], (b + 1) * turn),
          box[4],
          box[5],
          box[6],
          box[7],
          false,
        );
      }
    }
  }

  /** Sorts in a part of a box that lies in one cell of distance and angle. With `stays`, it remains in this chart. */
  private sector(
    i: number,
    a: number,
    b: number,
    least: number,
    most: number,
    t0: number,
    t1: number,
    w0: number,
    w1: number,
    L0: number,
    L1: number,
    stays: boolean,
  ): void {
    const { scene, grid, places, piece } = this;
    const chart = scene.charts[i];
    // What is so near to a hot asteroid has burned, and what is out of its range is lost unless another one is near.
    const d0 = Math.max(least, chart.burns - ROUNDING);
    if (d0 > most) return;
    places.sector(d0, most, t0, t1);
    if (this.isBlocked(chart, i)) return;
    const d1 = this.isOutOfOthers(chart, i) ? Math.min(most, scene.range + ROUNDING) : most;
    if (d0 > d1) return;
    if (d1 < most) places.sector(d0, d1, t0, t1);
    const nearest = stays ? OWN : this.nearest(chart, i);
    const { place, speed, momentum } = grid;
    const [c0, c1] = [Math.floor(w0 / speed), Math.floor(w1 / speed)];
    const e0 = Math.floor(L0 / momentum + OVERHANG);
    const e1 = Math.max(e0, Math.floor(L1 / momentum - OVERHANG));
    if (!this.mayLookAt((c1 - c0 + 1) * (e1 - e0 + 1))) return;
    for (let c = c0; c <= c1; c++) {
      const rate = Math.max(Math.abs(c), Math.abs(c + 1)) * speed;
      const v0 = Math.max(w0, c * speed);
      const v1 = Math.min(w1, (c + 1) * speed);
      for (let e = e0; e <= e1; e++) {
        const M0 = e === e0 ? L0 : e * momentum;
        const M1 = e === e1 ? L1 : (e + 1) * momentum;
        const across = (Math.max(Math.abs(e), Math.abs(e + 1)) * momentum) / (a * place);
        piece[0] = d0;
        piece[1] = d1;
        piece[4] = v0;
        piece[5] = v1;
        piece[6] = M0;
        piece[7] = M1;
        // All pieces of a cell are treated alike.
        const flight = this.flight(Math.sqrt(rate * rate + across * across));
        if (nearest >= 0) {
          piece[2] = t0;
          piece[3] = t1;
          this.toOther(i, nearest);
        } else if (
          !stays &&
          (!(a * place >= Math.max(CLOSE, SHARE * flight)) ||
            this.mayPassClose(a * place, -c * speed, Math.sqrt(rate * rate + across * across), M0, M1))
        ) {
          piece[2] = t0;
          piece[3] = t1;
          this.toNear(i, i);
        } else {
          const name = ((b % this.around) + this.around) % this.around;
          const back = (name - b) * this.turn;
          piece[2] = t0 + back;
          piece[3] = t1 + back;
          piece[8] = 0;
          piece[9] = 0;
          this.boxes.join(2 * i, a, name, c, e, 0, piece);
        }
      }
    }
  }

  /** Sorts in a box in x and y. */
  near(i: number, box: Float64Array): void {
    const { place } = this.grid;
    const [a0, a1] = [Math.floor(box[0] / place), Math.floor(box[1] / place)];
    const [b0, b1] = [Math.floor(box[2] / place), Math.floor(box[3] / place)];
    if (!this.mayLookAt((a1 - a0 + 1) * (b1 - b0 + 1))) return;
    for (let a = a0; a <= a1; a++) {
      for (let b = b0; b <= b1; b++) {
        this.rectangle(
          i,
          a,
          b,
          Math.max(box[0], a * place),
          Math.min(box[1], (a + 1) * place),
          Math.max(box[2], b * place),
          Math.min(box[3], (b + 1) * place),
          box,
          false,
        );
      }
    }
  }

  /** Sorts in a part of a box in x and y that lies in one cell of places. With `stays`, it remains in this chart. */
  private rectangle(
    i: number,
    a: number,
    b: number,
    x0: number,
    x1: number,
    y0: number,
    y1: number,
    box: Float64Array,
    stays: boolean,
  ): void {
    const { scene, grid, places } = this;
    const chart = scene.charts[i];
    places.rectangle(x0, x1, y0, y1);
    if (places.most < chart.burns - ROUNDING || this.isBlocked(chart, i)) return;
    if (places.least > scene.range + ROUNDING && this.isOutOfOthers(chart, i)) return;
    const { place, speed } = grid;
    const { least } = places;
    const [c0, c1] = [Math.floor(box[4] / speed), Math.floor(box[5] / speed)];
    const [e0, e1] = [Math.floor(box[6] / speed), Math.floor(box[7] / speed)];
    if (!this.mayLookAt((c1 - c0 + 1) * (e1 - e0 + 1))) return;
    const piece = this.nearPiece;
    for (let c = c0; c <= c1; c++) {
      const vx0 = Math.max(box[4], c * speed);
      const vx1 = Math.min(box[5], (c + 1) * speed);
      const xRate = Math.max(Math.abs(c), Math.abs(c + 1)) * speed;
      for (let e = e0; e <= e1; e++) {
        const vy0 = Math.max(box[6], e * speed);
        const vy1 = Math.min(box[7], (e + 1) * speed);
        const yRate = Math.max(Math.abs(e), Math.abs(e + 1)) * speed;
        if (stays) {
          const { x, y, least: slow, most: fast } = this.along;
          if (Math.min(x * vx0, x * vx1) + Math.min(y * vy0, y * vy1) > fast + ROUNDING) continue;
          if (Math.max(x * vx0, x * vx1) + Math.max(y * vy0, y * vy1) < slow - ROUNDING) continue;
        }
        piece[0] = x0;
        piece[1] = x1;
        piece[2] = y0;
        piece[3] = y1;
        piece[4] = vx0;
        piece[5] = vx1;
        piece[6] = vy0;
        piece[7] = vy1;
        // Angular momentum is x times the velocity along y, minus y times that along x.
        const xv0 = Math.min(x0 * vy0, x0 * vy1, x1 * vy0, x1 * vy1);
        const xv1 = Math.max(x0 * vy0, x0 * vy1, x1 * vy0, x1 * vy1);
        const yv0 = Math.min(y0 * vx0, y0 * vx1, y1 * vx0, y1 * vx1);
        const yv1 = Math.max(y0 * vx0, y0 * vx1, y1 * vx0, y1 * vx1);
        piece[8] = Math.max(box[8], xv0 - yv1 - ROUNDING);
        piece[9] = Math.min(box[9], xv1 - yv0 + ROUNDING);
        if (piece[8] > piece[9]) continue;
        const rate = Math.sqrt(xRate * xRate + yRate * yRate);
        const flight = this.flight(rate + 2 * speed + grid.momentum / CLOSE);
        const isOut = !stays && least >= Math.max(CLOSE + place, SHARE * flight + 2 * place);
        const nearing =
          Math.max(-x0 * vx0, -x0 * vx1, -x1 * vx0, -x1 * vx1) + Math.max(-y0 * vy0, -y0 * vy1, -y1 * vy0, -y1 * vy1);
        if (isOut && !this.mayPassClose(least - 2 * place, nearing / least + speed, rate, piece[8], piece[9]))
          this.toPolar(i, piece);
        else this.joinNear(i, a, b, c, e, least, piece);
      }
    }
  }

  private joinNear(i: number, a: number, b: number, c: number, e: number, least: number, piece: Float64Array): void {
    const { scene, grid } = this;
    if (least < IN_CENTRE) restInCentre(piece, 1e-3 * Math.sqrt(scene.push + 1));
    const { momentum } = grid;
    const f0 = Math.floor(piece[8] / momentum + OVERHANG);
    const f1 = Math.max(f0, Math.floor(piece[9] / momentum - OVERHANG));
    if (!this.mayLookAt(f1 - f0 + 1)) return;
    const [M0, M1] = [piece[8], piece[9]];
    for (let f = f0; f <= f1; f++) {
      piece[8] = f === f0 ? M0 : f * momentum;
      piece[9] = f === f1 ? M1 : (f + 1) * momentum;
      this.boxes.join(2 * i + 1, a, b, c, e, f, piece);
    }
    piece[8] = M0;
    piece[9] = M1;
  }

  /** Sorts the current piece, a sector in the chart of asteroid i, into that of asteroid j. */
  private toOther(i: number, j: number): void {
    const { grid, sight, velocity, turned, target, scene } = this;
    const [d0, d1, t0, t1, w0, w1, L0, L1] = this.piece;
    const from = this.rock(i, j);
    const blur = Math.max(this.moved[i], this.moved[j]);
    sight.ofSector(d0, d1, t0, t1, from, blur);
    this.measureVelocity(d0, d1, t0, t1, w0, w1, L0, L1);
    velocity.widen(scene.recoil * this.time);
    const fastest = Math.sqrt(
      Math.max(velocity.a0 * velocity.a0, velocity.a1 * velocity.a1) +
        Math.max(velocity.b0 * velocity.b0, velocity.b1 * velocity.b1),
    );
    const room = Math.max(CLOSE, SHARE * this.flight(fastest + grid.speed + grid.momentum / CLOSE)) + 2 * grid.place;
    this.momentumAbout(from, d0, d1, t0, t1, w0, w1, L0, L1);
    const [M0, M1] = [this.m0, this.m1];
    if (sight.d0 < room || this.mayPassClose(sight.d0, fastest, fastest, M0, M1)) {
      this.toNear(i, j);
      return;
    }
    const [s0, s1, u0, u1] = [sight.d0, sight.d1, sight.t0, sight.t1];
    const middle = (t0 + t1) / 2;
    const { place } = grid;
    const { turn } = this;
    const [a0, a1] = [Math.floor(s0 / place), Math.floor(s1 / place)];
    const [b0, b1] = [Math.floor(u0 / turn), Math.floor(u1 / turn)];
    if (!this.mayLookAt((a1 - a0 + 1) * (b1 - b0 + 1))) return;
    for (let a = a0; a <= a1; a++) {
      for (let b = b0; b <= b1; b++) {
        const e0 = Math.max(s0, a * place);
        const e1 = Math.min(s1, (a + 1) * place);
        const from0 = Math.max(u0, b * turn);
        const from1 = Math.min(u1, (b + 1) * turn);
        target.sector(e0, e1, from0, from1);
        target.look(-from.x, -from.y, from.r);
        if (target.near > d1 + blur + ROUNDING || target.far < d0 - blur - ROUNDING) continue;
        turned.copy(velocity);
        this.turnedSector(j, a, b, e0, e1, from0, from1, middle, M0, M1);
      }
    }
  }

  /** Sorts the current piece, a sector in the chart of asteroid i, into that of asteroid j, in x and y. */
  private toNear(i: number, j: number): void {
    const { places, velocity, made, target, grid, scene } = this;
    const [d0, d1, t0, t1, w0, w1, L0, L1] = this.piece;
    this.measureVelocity(d0, d1, t0, t1, w0, w1, L0, L1);
    const slip = i === j ? 0 : scene.recoil * this.time;
    velocity.widen(slip);
    const { along } = this;
    along.least = velocity.a0;
    along.most = velocity.a1;
    cosineAndSine((t0 + t1) / 2, this.axes, 0);
    along.x = this.axes[0];
    along.y = this.axes[1];
    velocity.onAxesTurnedBy(-(t0 + t1) / 2);
    places.sector(d0, d1, t0, t1);
    places.look(1, 0, 1);
    made[0] = places.dot0;
    made[1] = places.dot1;
    places.look(0, 1, 1);
    made[2] = places.dot0;
    made[3] = places.dot1;
    made[8] = L0;
    made[9] = L1;
    let [x, y, r, blur] = [0, 0, 0, 0];
    if (i !== j) {
      const from = this.rock(i, j);
      ({ x, y, r } = from);
      blur = Math.max(this.moved[i], this.moved[j]);
      this.momentumAbout(from, d0, d1, t0, t1, w0, w1, L0, L1);
      made[0] -= x + blur;
      made[1] += blur - x;
      made[2] -= y + blur;
      made[3] += blur - y;
      made[8] = this.m0;
      made[9] = this.m1;
    }
    made[4] = velocity.a0;
    made[5] = velocity.a1;
    made[6] = velocity.b0;
    made[7] = velocity.b1;
    const { place } = grid;
    const [a0, a1] = [Math.floor(made[0] / place), Math.floor(made[1] / place)];
    const [b0, b1] = [Math.floor(made[2] / place), Math.floor(made[3] / place)];
    if (!this.mayLookAt((a1 - a0 + 1) * (b1 - b0 + 1))) return;
    for (let a = a0; a <= a1; a++) {
      for (let b = b0; b <= b1; b++) {
        const x0 = Math.max(made[0], a * place);
        const x1 = Math.min(made[1], (a + 1) * place);
        const y0 = Math.max(made[2], b * place);
        const y1 = Math.min(made[3], (b + 1) * place);
        target.rectangle(x0, x1, y0, y1);
        target.look(-x, -y, r);
        if (target.near > d1 + blur + ROUNDING || target.far < d0 - blur - ROUNDING) continue;
        this.rectangle(j, a, b, x0, x1, y0, y1, made, true);
      }
    }
  }

  /** Sorts a piece in x and y into polar coordinates about the same asteroid. */
  private toPolar(i: number, [x0, x1, y0, y1, vx0, vx1, vy0, vy1, L0, L1]: Float64Array): void {
    const { sight, turned, target, grid, turn } = this;
    sight.ofRectangle(x0, x1, y0, y1);
    const [s0, s1, u0, u1] = [sight.d0, sight.d1, sight.t0, sight.t1];
    const { place } = grid;
    const [a0, a1] = [Math.floor(s0 / place), Math.floor(s1 / place)];
    const [b0, b1] = [Math.floor(u0 / turn), Math.floor(u1 / turn)];
    if (!this.mayLookAt((a1 - a0 + 1) * (b1 - b0 + 1))) return;
    for (let a = a0; a <= a1; a++) {
      for (let b = b0; b <= b1; b++) {
        const e0 = Math.max(s0, a * place);
        const e1 = Math.min(s1, (a + 1) * place);
        const from0 = Math.max(u0, b * turn);
        const from1 = Math.min(u1, (b + 1) * turn);
        target.sector(e0, e1, from0, from1);
        target.look(1, 0, 1);
        if (target.dot0 > x1 + ROUNDING || target.dot1 < x0 - ROUNDING) continue;
        target.look(0, 1, 1);
        if (target.dot0 > y1 + ROUNDING || target.dot1 < y0 - ROUNDING) continue;
        turned.set(vx0, vx1, vy0, vy1);
        this.turnedSector(i, a, b, e0, e1, from0, from1, 0, L0, L1);
      }
    }
  }

  /** Sorts in a cell of places, where `turned` is the velocity along axes at the angle `axes`. What has other momenta is left out. */
  private turnedSector(
    i: number,
    a: number,
    b: number,
    d0: number,
    d1: number,
    t0: number,
    t1: number,
    axes: number,
    L0: number,
    L1: number,
  ): void {
    const { turned } = this;
    turned.onAxesTurnedBy((t0 + t1) / 2 - axes);
    turned.tilt((t1 - t0) / 2);
    const across0 = Math.min(d0 * turned.b0, d1 * turned.b0);
    const across1 = Math.max(d0 * turned.b1, d1 * turned.b1);
    const M0 = Math.max(L0, across0 - ROUNDING);
    const M1 = Math.min(L1, across1 + ROUNDING);
    if (M0 <= M1) this.sector(i, a, b, d0, d1, t0, t1, turned.a0, turned.a1, M0, M1, true);
  }

  /** Sets `velocity` to that of a sector, along and across the direction to its middle. */
  private measureVelocity(d0: number, d1: number, t0: number, t1: number, w0: number, w1: number, L0: number, L1: number): void {
    this.velocity.set(w0, w1, Math.min(L0 / d0, L0 / d1), Math.max(L1 / d0, L1 / d1));
    this.velocity.tilt((t1 - t0) / 2);
  }

  private m0 = 0;
  private m1 = 0;

  /**
   * Sets `m0` and `m1` to bounds of the angular momentum about another asteroid. With its place A from this one, and y and v as
   * her place and velocity relative to this one, it is (y - A) x v = L (1 - A.y / d²) + w (A across).
   */
  private momentumAbout(
    from: Rock,
    d0: number,
    d1: number,
    t0: number,
    t1: number,
    w0: number,
    w1: number,
    L0: number,
    L1: number,
  ): void {
    const { places, scene, time } = this;
    places.sector(d0, d1, t0, t1);
    places.look(from.x, from.y, from.r);
    const { along0, along1, aside0, aside1 } = places;
    const k0 = 1 - Math.max(along1 / d0, along1 / d1);
    const k1 = 1 - Math.min(along0 / d0, along0 / d1);
    const own0 = Math.min(L0 * k0, L0 * k1, L1 * k0, L1 * k1);
    const own1 = Math.max(L0 * k0, L0 * k1, L1 * k0, L1 * k1);
    const by0 = Math.min(w0 * aside0, w0 * aside1, w1 * aside0, w1 * aside1);
    const by1 = Math.max(w0 * aside0, w0 * aside1, w1 * aside0, w1 * aside1);
    // what recoil can have added to the places and velocities of both asteroids
    const slip = scene.recoil * time;
    const blur = scene.recoil === 0 ? 0 : (slip * time) / 2;
    const across = Math.max(Math.abs(L0), Math.abs(L1)) / d0;
    const fastest = Math.max(-w0, w1, 0) + across;
    const drift = blur * (fastest + slip) + slip * (places.far + blur);
    this.m0 = own0 + by0 - drift - 1e-6;
    this.m1 = own1 + by1 + drift + 1e-6;
  }
}

/** Adds rest in the very centre to a box that contains a swing so small and so slow that the engine takes it for rest. */
function restInCentre(piece: Float64Array, slow: number): void {
  if (piece[4] > slow || piece[5] < -slow || piece[6] > slow || piece[7] < -slow) return;
  if (piece[8] > 1e-6 || piece[9] < -1e-6) return;
  for (let k = 0; k < SIZE; k += 2) {
    piece[k] = Math.min(piece[k], 0);
    piece[k + 1] = Math.max(piece[k + 1], 0);
  }
}

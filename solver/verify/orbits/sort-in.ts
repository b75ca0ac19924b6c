import type { OrbitGrid } from '../../prove/index.ts';
import { leastProduct, mostProduct } from './arithmetic.ts';
import { Boxes, SIZE } from './boxes.ts';
import { type Drifts, ROUNDING, type Scene } from './scene.ts';
import { type Along, type PutPart, Transfer } from './transfer.ts';
import { CLOSE, OWN, SHARE, Whereabouts } from './whereabouts.ts';

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
export class Sorter {
  /** The pieces that were looked at. */
  looked = 0;
  private readonly scene: Scene;
  private readonly grid: OrbitGrid;
  private readonly most: number;
  private readonly turn: number;
  private readonly around: number;
  private boxes = new Boxes();
  private readonly where: Whereabouts;
  private readonly transfer: Transfer;
  private readonly piece = new Float64Array(SIZE);
  private readonly nearPiece = new Float64Array(SIZE);

  /**
   * @param most - the most pieces to look at; no more are put into the boxes
   */
  constructor(scene: Scene, drifts: Drifts, grid: OrbitGrid, most: number) {
    this.scene = scene;
    this.grid = grid;
    this.most = most;
    this.around = Math.round((2 * Math.PI * 100) / grid.place);
    this.turn = (2 * Math.PI) / this.around;
    this.where = new Whereabouts(scene, drifts);
    this.transfer = new Transfer(scene, drifts, grid, this.turn, this.where, this);
  }

  /** Puts everything that follows into these boxes. */
  into(boxes: Boxes): void {
    this.boxes = boxes;
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

  cut(p0: number, p1: number, q0: number, q1: number, side: number, put: PutPart): void {
    const { place } = this.grid;
    const [a0, a1] = [Math.floor(p0 / place), Math.floor(p1 / place)];
    const [b0, b1] = [Math.floor(q0 / side), Math.floor(q1 / side)];
    if (!this.mayLookAt((a1 - a0 + 1) * (b1 - b0 + 1))) return;
    for (let a = a0; a <= a1; a++) {
      const from = Math.max(p0, a * place);
      const to = Math.min(p1, (a + 1) * place);
      for (let b = b0; b <= b1; b++) put(a, b, from, to, Math.max(q0, b * side), Math.min(q1, (b + 1) * side));
    }
  }

  /** Sorts in a box in polar coordinates. */
  polar(i: number, box: Float64Array): void {
    this.cut(box[0], box[1], box[2], box[3], this.turn, (a, b, d0, d1, t0, t1) =>
      this.sector(i, a, b, d0, d1, t0, t1, box[4], box[5], box[6], box[7], false),
    );
  }

  /** Sorts in a part of a box that lies in one cell of distance and angle. With `stays`, it remains in this chart. */
  sector(
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
    const { scene, grid, where, transfer, piece } = this;
    const { places } = where;
    const chart = scene.charts[i];
    // What is so near to a hot asteroid has burned, and what is out of its range is lost unless another one is near.
    const d0 = Math.max(least, chart.burns - ROUNDING);
    if (d0 > most) return;
    places.sector(d0, most, t0, t1);
    if (where.isBlocked(chart, i)) return;
    const d1 = where.isOutOfOthers(chart, i) ? Math.min(most, scene.range + ROUNDING) : most;
    if (d0 > d1) return;
    if (d1 < most) places.sector(d0, d1, t0, t1);
    const nearest = stays ? OWN : where.nearest(chart, i);
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
        const flight = where.flight(Math.sqrt(rate * rate + across * across));
        if (nearest >= 0) {
          piece[2] = t0;
          piece[3] = t1;
          transfer.toOther(i, nearest, piece);
        } else if (
          !stays &&
          (!(a * place >= Math.max(CLOSE, SHARE * flight)) ||
            where.mayPassClose(a * place, -c * speed, Math.sqrt(rate * rate + across * across), M0, M1))
        ) {
          piece[2] = t0;
          piece[3] = t1;
          transfer.toNear(i, i, piece);
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
    this.cut(box[0], box[1], box[2], box[3], this.grid.place, (a, b, x0, x1, y0, y1) =>
      this.rectangle(i, a, b, x0, x1, y0, y1, box, null),
    );
  }

  /**
   * Sorts in a part of a box in x and y that lies in one cell of places. With `along`, it has only velocities within those bounds,
   * and remains in this chart.
   */
  rectangle(
    i: number,
    a: number,
    b: number,
    x0: number,
    x1: number,
    y0: number,
    y1: number,
    box: Float64Array,
    along: Along | null,
  ): void {
    const { scene, grid, where } = this;
    const { places } = where;
    const chart = scene.charts[i];
    places.rectangle(x0, x1, y0, y1);
    if (places.most < chart.burns - ROUNDING || where.isBlocked(chart, i)) return;
    if (places.least > scene.range + ROUNDING && where.isOutOfOthers(chart, i)) return;
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
        if (along !== null) {
          const { x, y, least: slow, most: fast } = along;
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
        piece[8] = Math.max(box[8], leastProduct(x0, x1, vy0, vy1) - mostProduct(y0, y1, vx0, vx1) - ROUNDING);
        piece[9] = Math.min(box[9], mostProduct(x0, x1, vy0, vy1) - leastProduct(y0, y1, vx0, vx1) + ROUNDING);
        if (piece[8] > piece[9]) continue;
        const rate = Math.sqrt(xRate * xRate + yRate * yRate);
        const flight = where.flight(rate + 2 * speed + grid.momentum / CLOSE);
        const isOut = along === null && least >= Math.max(CLOSE + place, SHARE * flight + 2 * place);
        const nearing = mostProduct(-x0, -x1, vx0, vx1) + mostProduct(-y0, -y1, vy0, vy1);
        if (isOut && !where.mayPassClose(least - 2 * place, nearing / least + speed, rate, piece[8], piece[9]))
          this.transfer.toPolar(i, piece);
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

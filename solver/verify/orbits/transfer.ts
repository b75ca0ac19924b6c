import type { OrbitGrid } from '../../prove/index.ts';
import { cosineAndSine, leastProduct, mostProduct, mostSquare, Vector } from './arithmetic.ts';
import { SIZE } from './boxes.ts';
import { Places } from './places.ts';
import { type Drifts, ROUNDING, type Rock, type Scene } from './scene.ts';
import { Sight } from './sight.ts';
import { CLOSE, SHARE, type Whereabouts } from './whereabouts.ts';

/** A direction, and bounds of the velocity along it, px/s. */
export interface Along {
  x: number;
  y: number;
  least: number;
  most: number;
}

/** Called with a cell and the part of something that lies in it: bounds of both coordinates. */
export type PutPart = (a: number, b: number, p0: number, p1: number, q0: number, q1: number) => void;

/** Where pieces go that were taken to another chart: each lies in one cell of places, a and b, and stays in the chart of asteroid i. */
interface Cells {
  /** Cuts bounds of two coordinates along the cells, which have this side along the second, px or rad; not if they are too many. */
  cut(p0: number, p1: number, q0: number, q1: number, side: number, put: PutPart): void;
  sector(
    i: number,
    a: number,
    b: number,
    d0: number,
    d1: number,
    t0: number,
    t1: number,
    w0: number,
    w1: number,
    L0: number,
    L1: number,
    stays: true,
  ): void;
  rectangle(
    i: number,
    a: number,
    b: number,
    x0: number,
    x1: number,
    y0: number,
    y1: number,
    box: Float64Array,
    along: Along,
  ): void;
}

/** Takes pieces of boxes to the charts of other asteroids, and from polar coordinates to x and y and back. */
export class Transfer {
  private readonly scene: Scene;
  private readonly drifts: Drifts;
  private readonly grid: OrbitGrid;
  private readonly turn: number;
  private readonly where: Whereabouts;
  private readonly cells: Cells;
  private readonly places = new Places();
  private readonly target = new Places();
  private readonly velocity = new Vector();
  private readonly turned = new Vector();
  private readonly sight = new Sight();
  private readonly axes = new Float64Array(2);
  private readonly made = new Float64Array(SIZE);
  /** What has other velocities is not in the piece that is sorted in. */
  private readonly along: Along = { x: 0, y: 0, least: 0, most: 0 };
  // what `momentumAbout` found, px²/s
  private m0 = 0;
  private m1 = 0;

  /** @param turn - the angle of a cell, rad */
  constructor(scene: Scene, drifts: Drifts, grid: OrbitGrid, turn: number, where: Whereabouts, cells: Cells) {
    this.scene = scene;
    this.drifts = drifts;
    this.grid = grid;
    this.turn = turn;
    this.where = where;
    this.cells = cells;
  }

  /** Sorts a piece, a sector in the chart of asteroid i, into that of asteroid j. */
  toOther(i: number, j: number, piece: Float64Array): void {
    const { drifts, grid, scene, sight, target, velocity, where } = this;
    const [d0, d1, t0, t1, w0, w1, L0, L1] = piece;
    const from = where.rock(i, j);
    const blur = drifts.between(i, j);
    sight.ofSector(d0, d1, t0, t1, from, blur);
    this.measureVelocity(d0, d1, t0, t1, w0, w1, L0, L1);
    velocity.widen(scene.recoil * drifts.time);
    const fastest = Math.sqrt(mostSquare(velocity.a0, velocity.a1) + mostSquare(velocity.b0, velocity.b1));
    const room = Math.max(CLOSE, SHARE * where.flight(fastest + grid.speed + grid.momentum / CLOSE)) + 2 * grid.place;
    this.momentumAbout(from, d0, d1, t0, t1, w0, w1, L0, L1);
    const [M0, M1] = [this.m0, this.m1];
    if (sight.d0 < room || where.mayPassClose(sight.d0, fastest, fastest, M0, M1)) {
      this.toNear(i, j, piece);
      return;
    }
    this.intoSectors(j, (t0 + t1) / 2, M0, M1, () => {
      target.look(-from.x, -from.y, from.r);
      return !(target.near > d1 + blur + ROUNDING || target.far < d0 - blur - ROUNDING);
    });
  }

  /** Sorts a piece, a sector in the chart of asteroid i, into that of asteroid j, in x and y. */
  toNear(i: number, j: number, piece: Float64Array): void {
    const { along, cells, drifts, grid, made, places, scene, target, velocity, where } = this;
    const [d0, d1, t0, t1, w0, w1, L0, L1] = piece;
    this.measureVelocity(d0, d1, t0, t1, w0, w1, L0, L1);
    const slip = i === j ? 0 : scene.recoil * drifts.time;
    velocity.widen(slip);
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
      const from = where.rock(i, j);
      ({ x, y, r } = from);
      blur = drifts.between(i, j);
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
    cells.cut(made[0], made[1], made[2], made[3], grid.place, (a, b, x0, x1, y0, y1) => {
      target.rectangle(x0, x1, y0, y1);
      target.look(-x, -y, r);
      if (target.near > d1 + blur + ROUNDING || target.far < d0 - blur - ROUNDING) return;
      cells.rectangle(j, a, b, x0, x1, y0, y1, made, along);
    });
  }

  /** Sorts a piece in x and y into polar coordinates about the same asteroid. */
  toPolar(i: number, [x0, x1, y0, y1, vx0, vx1, vy0, vy1, L0, L1]: Float64Array): void {
    const { target } = this;
    this.sight.ofRectangle(x0, x1, y0, y1);
    this.velocity.set(vx0, vx1, vy0, vy1);
    this.intoSectors(i, 0, L0, L1, () => {
      target.look(1, 0, 1);
      if (target.dot0 > x1 + ROUNDING || target.dot1 < x0 - ROUNDING) return false;
      target.look(0, 1, 1);
      return !(target.dot0 > y1 + ROUNDING || target.dot1 < y0 - ROUNDING);
    });
  }

  /**
   * Sorts in what `sight` shows, with `velocity` along axes at the angle `axes`, in polar coordinates.
   * @param isThere - whether a part of it may lie at the places of `target`
   */
  private intoSectors(i: number, axes: number, L0: number, L1: number, isThere: () => boolean): void {
    const { cells, sight, target, turn } = this;
    cells.cut(sight.d0, sight.d1, sight.t0, sight.t1, turn, (a, b, d0, d1, t0, t1) => {
      target.sector(d0, d1, t0, t1);
      if (isThere()) this.intoSector(i, a, b, d0, d1, t0, t1, axes, L0, L1);
    });
  }

  /** Sorts in one cell of places. What has other momenta is left out. */
  private intoSector(
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
    const { cells, turned, velocity } = this;
    turned.copy(velocity);
    turned.onAxesTurnedBy((t0 + t1) / 2 - axes);
    turned.tilt((t1 - t0) / 2);
    const across0 = Math.min(d0 * turned.b0, d1 * turned.b0);
    const across1 = Math.max(d0 * turned.b1, d1 * turned.b1);
    const M0 = Math.max(L0, across0 - ROUNDING);
    const M1 = Math.min(L1, across1 + ROUNDING);
    if (M0 <= M1) cells.sector(i, a, b, d0, d1, t0, t1, turned.a0, turned.a1, M0, M1, true);
  }

  /** Sets `velocity` to that of a sector, along and across the direction to its middle. */
  private measureVelocity(d0: number, d1: number, t0: number, t1: number, w0: number, w1: number, L0: number, L1: number): void {
    this.velocity.set(w0, w1, Math.min(L0 / d0, L0 / d1), Math.max(L1 / d0, L1 / d1));
    this.velocity.tilt((t1 - t0) / 2);
  }

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
    const { places, scene } = this;
    const { time } = this.drifts;
    places.sector(d0, d1, t0, t1);
    places.look(from.x, from.y, from.r);
    const { along0, along1, aside0, aside1 } = places;
    const k0 = 1 - Math.max(along1 / d0, along1 / d1);
    const k1 = 1 - Math.min(along0 / d0, along0 / d1);
    // what recoil can have added to the places and velocities of both asteroids
    const slip = scene.recoil * time;
    const blur = scene.recoil === 0 ? 0 : (slip * time) / 2;
    const across = Math.max(Math.abs(L0), Math.abs(L1)) / d0;
    const fastest = Math.max(-w0, w1, 0) + across;
    const drift = blur * (fastest + slip) + slip * (places.far + blur);
    this.m0 = leastProduct(L0, L1, k0, k1) + leastProduct(w0, w1, aside0, aside1) - drift - 1e-6;
    this.m1 = mostProduct(L0, L1, k0, k1) + mostProduct(w0, w1, aside0, aside1) + drift + 1e-6;
  }
}

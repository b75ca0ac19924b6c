import { TICK } from '../../../engine/index.ts';
import { driftAfter, easySpeed, isEasyFor } from '../assumptions.ts';
import type { About, Blocker, OrbitGrid } from '../proof.ts';
import { RIM_SLACK } from '../rims.ts';
import { distance } from '../rounding.ts';
import type { Setting, Thing } from '../setting.ts';
import { agree, leastSquare, mostSquare } from './agree.ts';
import { Layer, NUMBERS } from './layer.ts';
import { Rectangle } from './rectangle.ts';
import { type OrbitScene, orbitScene, type Place } from './scene.ts';
import { atan2, cos, sin } from './trigonometry.ts';

const SLACK = 1e-6;
/** In a part of a step, distance changes by about this share of itself, or direction by this many rad. */
const BEND = 0.12;
/** Length of a part near the centre, s. */
const NEAR_PART = 0.1;
const MOST_PARTS = 8;
/** Boxes are Cartesian nearer than this, px, or where she may turn about the centre more quickly than this, rad/s. */
const INNER = 16;
const QUICK = 3;
const RANGE: Blocker = { kind: 'range' };

/** Everything that she may do from the start, as far as it was followed. */
export interface OrbitResult {
  /** Every run has ended, and none came near the object. */
  readonly closed: boolean;
  /** Number of complete steps. */
  readonly steps: number;
  /** Number of boxes in all layers. */
  readonly boxes: number;
  /** Why it gave up; empty when it did not. */
  readonly why: string;
  /** What ended runs; `range` stands for the end of the range. */
  readonly endedBy: readonly Blocker[];
}

/** What is told on the way, for tests and pictures. */
export interface OrbitWatch {
  /** Called with the boxes at the start of each step, which is numbered from 0. */
  readonly layer?: (layer: Layer, step: number) => void;
  /** Called with rectangles that contain the places of a part of a step: least and greatest x and y, px from the start. */
  readonly places?: (x0: number, x1: number, y0: number, y1: number) => void;
}

/**
 * Computes the reachable set from the start, step by step, about the nearest asteroid. A box holds distance, direction, radial
 * speed and angular momentum about one asteroid, and half the square of the speed. The last number depends on the others, but
 * nothing that only turns her path changes it, so it keeps boxes from growing on the way past an asteroid. Near the centre, where
 * directions change quickly, a box holds place and velocity along the axes instead of the first three. After each step boxes are
 * divided along the grid, and those of one cell are joined; where another asteroid may be the nearest, a box is put into that
 * asteroid's chart as well. It gives up when she may come near the object or a mouth, or after the given number of steps or boxes.
 */
export function followOrbits(
  setting: Setting,
  about: About,
  goal: Thing,
  grid: OrbitGrid,
  most: { readonly steps: number; readonly boxes: number },
  watch: OrbitWatch = {},
): OrbitResult {
  const fan = new OrbitFan(setting, about, goal, grid, watch);
  let boxes = 0;
  const end = (closed: boolean, steps: number, why: string): OrbitResult => ({
    closed,
    steps,
    boxes,
    why,
    endedBy: [...fan.endedBy],
  });
  if (!fan.fits() || !isEasyFor(setting, grid.frames * TICK)) return end(false, 0, 'the grid is too fine or she is too fast');
  // what she touches at the start counts, even if a hazard ends the run there
  if (distance(goal, { x: 0, y: 0 }) <= goal.touch + SLACK) return end(false, 0, 'the object is at the start');
  let now = fan.start();
  let next = new Layer();
  for (let step = 0; step <= most.steps; step++) {
    watch.layer?.(now, step);
    if (now.size === 0) return end(true, step, '');
    boxes += now.size;
    if (boxes > most.boxes) return end(false, step, 'there are too many boxes');
    next.clear();
    if (!fan.advance(now, step + 1, next)) return end(false, step, fan.why);
    [now, next] = [next, now];
  }
  return end(false, most.steps, 'runs go on');
}

class OrbitFan {
  readonly endedBy = new Set<Blocker>();
  why = '';
  private readonly setting: Setting;
  private readonly grid: OrbitGrid;
  private readonly watch: OrbitWatch;
  /** Length of a step and of the present part of one, s. */
  private readonly step: number;
  private h = 0;
  private isPolar = false;
  private readonly turns: number;
  private readonly turn: number;
  private readonly rocks: OrbitScene['rocks'];
  private readonly hazards: OrbitScene['hazards'];
  private readonly own: OrbitScene['own'];
  private readonly fields: OrbitScene['fields'];
  private readonly winds: OrbitScene['winds'];
  private readonly mouths: OrbitScene['mouths'];
  private readonly goal: OrbitScene['goal'];
  private readonly raw = new Layer();
  private readonly reach: number;
  private readonly radix: readonly number[];
  private readonly crowded: boolean;
  private readonly fastest: number;
  // the present step
  private drift: number[] = [];
  private shift: number[] = [];
  private readonly rect = new Rectangle();
  // accelerations
  private ax0 = 0;
  private ax1 = 0;
  private ay0 = 0;
  private ay1 = 0;
  private inField = false;
  private mark = 0;
  private foreign = false;
  // velocity
  private readonly box = new Float64Array(NUMBERS);
  private readonly part = new Float64Array(NUMBERS);
  private readonly made = new Float64Array(NUMBERS);
  private readonly cut = new Float64Array(NUMBERS);
  private vx0 = 0;
  private vx1 = 0;
  private vy0 = 0;
  private vy1 = 0;

  constructor(setting: Setting, about: About, goal: Thing, grid: OrbitGrid, watch: OrbitWatch) {
    this.watch = watch;
    const { level, rules } = setting;
    this.setting = setting;
    this.grid = grid;
    this.step = grid.frames * TICK;
    this.turns = Math.max(4, Math.round((2 * Math.PI * 100) / grid.place));
    this.turn = (2 * Math.PI) / this.turns;
    const scene = orbitScene(setting, about, goal);
    this.rocks = scene.rocks;
    this.hazards = scene.hazards;
    this.own = scene.own;
    this.fields = scene.fields;
    this.winds = scene.winds;
    this.mouths = scene.mouths;
    this.goal = scene.goal;
    this.crowded = this.rocks.length > 1 || this.fields.length > 0 || this.winds.length > 0;
    this.fastest = easySpeed(rules);
    this.reach = level.range + this.fastest * this.step;
    const cells = 2 * Math.ceil(this.reach / grid.place) + 4;
    const speeds = 2 * Math.ceil(this.fastest / grid.speed) + 4;
    const momenta = 2 * Math.ceil((1.5 * this.reach * this.fastest) / grid.momentum) + 4;
    this.radix = [cells, Math.max(cells, this.turns), speeds, speeds, momenta];
  }

  fits(): boolean {
    return this.radix.reduce((a, b) => a * b, 2 * this.rocks.length) < Number.MAX_SAFE_INTEGER;
  }

  start(): Layer {
    const { vx, vy } = this.setting.level.astronaut;
    const layer = new Layer();
    this.drift = this.rocks.map(() => 0);
    this.shift = this.rocks.map(() => 0);
    for (const [i, rock] of this.rocks.entries()) {
      const { made } = this;
      made[0] = -rock.x - SLACK;
      made[1] = -rock.x + SLACK;
      made[2] = -rock.y - SLACK;
      made[3] = -rock.y + SLACK;
      made[4] = vx - SLACK;
      made[5] = vx + SLACK;
      made[6] = vy - SLACK;
      made[7] = vy + SLACK;
      const L = -rock.x * vy + rock.y * vx;
      const s = this.slackL(L);
      made[8] = L - s;
      made[9] = L + s;
      const E = (vx * vx + vy * vy) / 2;
      made[10] = E - 1e-4 - 1e-8 * E;
      made[11] = E + 1e-4 + 1e-8 * E;
      // source is a Cartesian box about i
      this.convert(made.slice(), 2 * i + 1, i, layer);
    }
    return layer;
  }

  private slackL(L: number): number {
    return 1e-4 + 1e-8 * Math.abs(L);
  }

  advance(now: Layer, step: number, next: Layer): boolean {
    const { raw, box, rocks, setting } = this;
    const time = step * this.step;
    this.drift = rocks.map((_, i) => driftAfter(setting, i, time));
    this.shift = rocks.map(({ k }) => k * (time + TICK));
    raw.clear();
    const cost = 8 + 2 * rocks.length + this.fields.length + 2 * this.hazards.length;
    for (let b = 0; b < now.size; b++) {
      setting.budget.look(cost / 8);
      for (let n = 0, o = b * NUMBERS; n < NUMBERS; n++, o++) box[n] = now.boxes[o];
      const chart = now.charts[b];
      if (!this.move(chart >> 1, chart % 2 === 0)) return false;
    }
    return this.settle(next);
  }

  /** Follows the present box through a step, in parts that are short where she turns quickly, and puts it into its cells. */
  private move(i: number, isPolar: boolean): boolean {
    const { box } = this;
    this.mark = 0;
    this.isPolar = isPolar;
    const lm = Math.max(-box[8], box[9]);
    const rate = isPolar ? (lm / box[0] + Math.max(-box[4], box[5])) / box[0] / BEND : 1 / NEAR_PART;
    const parts = Math.max(1, Math.min(MOST_PARTS, Math.ceil(this.step * rate - 1e-9)));
    this.h = this.step / parts;
    this.setting.budget.look(parts * (1 + this.rocks.length / 4 + this.hazards.length / 8));
    for (let n = 0; n < parts; n++) {
      if (!(this.isPolar ? this.movePolar(i) : this.moveNear(i))) return false;
      if (this.isPolar && !agree(box)) return true;
    }
    return this.isPolar ? this.putPolar(this.raw, i, box, false) : this.putNear(this.raw, i, box, false);
  }

  // ---------------------------------------------------------------- geometry
  /** Least and greatest distance of a place from the rectangle about asteroid i, px. */
  private near(i: number, { x, y }: Place): number {
    return this.rect.near(x - this.rocks[i].x, y - this.rocks[i].y);
  }

  private far(i: number, { x, y }: Place): number {
    return this.rect.far(x - this.rocks[i].x, y - this.rocks[i].y);
  }

  /** Whether j may be nearer than i somewhere in the rectangle. */
  private mayBeNearer(i: number, j: number): boolean {
    const ox = this.rocks[j].x - this.rocks[i].x;
    const oy = this.rocks[j].y - this.rocks[i].y;
    const x = ox * this.rect.ca + oy * this.rect.sa;
    const y = oy * this.rect.ca - ox * this.rect.sa;
    const most = (x > 0 ? x * this.rect.X1 : x * this.rect.X0) + (y > 0 ? y * this.rect.Y1 : y * this.rect.Y0);
    const square = ox * ox + oy * oy;
    const D = this.drift[i] + this.drift[j];
    return most + D * (this.rect.farthest() + Math.sqrt(square)) + SLACK * (1 + Math.sqrt(square)) >= square / 2;
  }

  /** Whether she may come nearer to j faster than to i, so that j may become the nearest in this step. */
  private mayCross(i: number, j: number, isPolar: boolean): boolean {
    const { rocks, drift, shift, h } = this;
    const ox = rocks[j].x - rocks[i].x;
    const oy = rocks[j].y - rocks[i].y;
    const o = Math.sqrt(ox * ox + oy * oy);
    this.velocity(this.box, isPolar, atan2(oy, ox));
    const D = drift[i] + drift[j];
    const V = shift[i] + shift[j];
    const gain = h * (this.setting.strongest + rocks[i].k);
    const speed = Math.max(-this.vx0, this.vx1) + Math.max(-this.vy0, this.vy1) + 2 * gain;
    return o * (this.vx1 + gain) + D * speed + V * (this.rect.farthest() + o + D) + SLACK > 0;
  }

  /** Whether i may be the nearest somewhere in the rectangle. */
  private mayBeNearest(i: number): boolean {
    for (let j = 0; j < this.rocks.length; j++) {
      if (j === i) continue;
      const ox = this.rocks[j].x - this.rocks[i].x;
      const oy = this.rocks[j].y - this.rocks[i].y;
      const x = ox * this.rect.ca + oy * this.rect.sa;
      const y = oy * this.rect.ca - ox * this.rect.sa;
      const least = (x > 0 ? x * this.rect.X0 : x * this.rect.X1) + (y > 0 ? y * this.rect.Y0 : y * this.rect.Y1);
      const square = ox * ox + oy * oy;
      const D = this.drift[i] + this.drift[j];
      if (least - D * (this.rect.farthest() + Math.sqrt(square)) - D * D - SLACK * (1 + Math.sqrt(square)) > square / 2)
        return false;
    }
    return true;
  }

  private isDead(i: number, d1: number): boolean {
    const { rocks } = this;
    const own = this.own[i];
    if (own !== null && d1 < rocks[i].radius + this.setting.leastHalf - SLACK) {
      this.endedBy.add(own);
      return true;
    }
    for (const hazard of this.hazards) {
      if (this.far(i, hazard) + this.drift[i] >= hazard.r - SLACK) continue;
      this.endedBy.add(hazard.of);
      return true;
    }
    return false;
  }

  /** Whether she may touch what nobody follows. */
  private isClear(i: number): boolean {
    if (this.watch.places !== undefined) this.tellPlaces(i, this.watch.places);
    if (this.near(i, this.goal) - this.drift[i] <= this.goal.r + SLACK) {
      this.why = 'she may come near the object';
      return false;
    }
    for (const mouth of this.mouths) {
      if (this.near(i, mouth) - this.drift[i] <= mouth.r + RIM_SLACK) {
        this.why = 'she may enter a mouth';
        return false;
      }
    }
    return true;
  }

  private tellPlaces(i: number, places: NonNullable<OrbitWatch['places']>): void {
    const { ca, sa, X0, X1, Y0, Y1 } = this.rect;
    const { x, y } = this.rocks[i];
    const D = this.drift[i];
    const x0 = Math.min(X0 * ca, X1 * ca) - Math.max(Y0 * sa, Y1 * sa);
    const x1 = Math.max(X0 * ca, X1 * ca) - Math.min(Y0 * sa, Y1 * sa);
    const y0 = Math.min(X0 * sa, X1 * sa) + Math.min(Y0 * ca, Y1 * ca);
    const y1 = Math.max(X0 * sa, X1 * sa) + Math.max(Y0 * ca, Y1 * ca);
    places(x + x0 - D, x + x1 + D, y + y0 - D, y + y1 + D);
  }

  // ---------------------------------------------------------------- forces
  private include(x0: number, x1: number, y0: number, y1: number): void {
    this.ax0 = Math.min(this.ax0, x0);
    this.ax1 = Math.max(this.ax1, x1);
    this.ay0 = Math.min(this.ay0, y0);
    this.ay1 = Math.max(this.ay1, y1);
  }

  /** The accelerations of everything but the asteroid itself, in the rectangle's frame. */
  private forces(i: number, isPolar: boolean): void {
    const { rocks, drift } = this;
    const { pull, push } = this.setting.rules;
    this.inField = false;
    this.foreign = false;
    this.ax0 = this.ay0 = Number.POSITIVE_INFINITY;
    this.ax1 = this.ay1 = Number.NEGATIVE_INFINITY;
    for (const field of this.fields) {
      const near = this.near(i, field) - drift[i];
      if (near > field.r + SLACK) continue;
      this.foreign = true;
      const far = this.far(i, field) + drift[i];
      if (far < field.r - SLACK) this.inField = true;
      if (near < 1) {
        this.include(-push, push, -push, push);
        continue;
      }
      const rx = field.x - rocks[i].x;
      const ry = field.y - rocks[i].y;
      const x = rx * this.rect.ca + ry * this.rect.sa;
      const y = ry * this.rect.ca - rx * this.rect.sa;
      const g0 = push / far;
      const g1 = push / near;
      const D = drift[i];
      this.include(
        least(this.rect.X0 - x - D, g0, g1),
        greatest(this.rect.X1 - x + D, g0, g1),
        least(this.rect.Y0 - y - D, g0, g1),
        greatest(this.rect.Y1 - y + D, g0, g1),
      );
    }
    if (!this.inField) this.include(0, 0, 0, 0);
    const { range } = this.setting.level;
    for (let j = 0; j < rocks.length; j++) {
      if (j === i || !this.mayBeNearer(i, j) || !((this.mark & (1 << (j & 31))) !== 0 || this.mayCross(i, j, isPolar))) continue;
      this.foreign = true;
      this.mark |= 1 << (j & 31);
      // Inside a field the gun does not act, but the nearest asteroid may change.
      if (this.inField) continue;
      const D = drift[i] + drift[j];
      const near = this.near(i, rocks[j]) - D;
      if (near < 1) {
        this.include(-pull, pull, -pull, pull);
        continue;
      }
      const far = this.far(i, rocks[j]) + D;
      const g0 = Math.max(0, pull * (1 / far - 1 / range));
      const g1 = Math.max(0, pull * (1 / near - 1 / range));
      const rx = rocks[j].x - rocks[i].x;
      const ry = rocks[j].y - rocks[i].y;
      const x = rx * this.rect.ca + ry * this.rect.sa;
      const y = ry * this.rect.ca - rx * this.rect.sa;
      this.include(
        least(x - D - this.rect.X1, g0, g1),
        greatest(x + D - this.rect.X0, g0, g1),
        least(y - D - this.rect.Y1, g0, g1),
        greatest(y + D - this.rect.Y0, g0, g1),
      );
    }
    for (const wind of this.winds) {
      if (this.near(i, wind) - drift[i] > wind.r + RIM_SLACK) continue;
      this.foreign = true;
      const isIn = this.far(i, wind) + drift[i] < wind.r - RIM_SLACK;
      const x = wind.ax * this.rect.ca + wind.ay * this.rect.sa;
      const y = wind.ay * this.rect.ca - wind.ax * this.rect.sa;
      this.windX0 += isIn ? x : Math.min(0, x);
      this.windX1 += isIn ? x : Math.max(0, x);
      this.windY0 += isIn ? y : Math.min(0, y);
      this.windY1 += isIn ? y : Math.max(0, y);
    }
  }
  private windX0 = 0;
  private windX1 = 0;
  private windY0 = 0;
  private windY1 = 0;

  // ---------------------------------------------------------------- steps
  private movePolar(i: number): boolean {
    const { box, h, rocks, setting } = this;
    const [d0, d1, t0, t1, w0, w1, , , l0, l1] = box;
    const k = rocks[i].k;
    const { pull } = setting.rules;
    const { range } = setting.level;
    const strongest = setting.strongest;
    const A = strongest + k;
    const lm = Math.max(-l0, l1);
    const wm = Math.max(-w0, w1);
    const v = Math.sqrt(Math.min(wm * wm + (lm / d0) * (lm / d0), 2 * box[11])) + A * h;
    if (v > this.fastest) {
      this.why = 'she may be too fast';
      return false;
    }
    const dl = this.crowded ? h * (d1 + v * h) * strongest : 0;
    const e0 = Math.min(d0, d0 + w0 * h - 0.5 * A * h * h);
    if (e0 < 2) {
      this.toNear(box, i);
      this.isPolar = false;
      return this.moveNear(i);
    }
    let m = lm + dl;
    let c1 = (m * m) / (e0 * e0 * e0);
    const e1 = Math.max(d1, d1 + w1 * h + 0.5 * (c1 + (this.crowded ? strongest : 0)) * h * h);
    const r0 = l0 - dl >= 0 ? (l0 - dl) / (e1 * e1) : (l0 - dl) / (e0 * e0);
    const r1 = l1 + dl >= 0 ? (l1 + dl) / (e0 * e0) : (l1 + dl) / (e1 * e1);
    this.rect.sector(e0, e1, t0 + Math.min(0, r0 * h), t1 + Math.max(0, r1 * h));
    if (!this.isClear(i)) return false;
    this.windX0 = this.windX1 = this.windY0 = this.windY1 = 0;
    let R0 = 0;
    let R1 = 0;
    let T0 = 0;
    let T1 = 0;
    if (this.crowded) this.forces(i, true);
    const isForeign = this.crowded && this.foreign;
    if (isForeign) {
      const c = cos(this.rect.delta);
      const s = sin(this.rect.delta);
      const xm = Math.max(-this.ax0, this.ax1, 0);
      const ym = Math.max(-this.ay0, this.ay1, 0);
      R0 = Math.min(this.ax0, this.ax0 * c) - ym * s;
      R1 = Math.max(this.ax1, this.ax1 * c) + ym * s;
      T0 = Math.min(this.ay0, this.ay0 * c) - xm * s;
      T1 = Math.max(this.ay1, this.ay1 * c) + xm * s;
    }
    // paths
    const a1 = Math.max(0, pull * (1 - e0 / range));
    const lowPull = isForeign ? Math.min(R0, this.inField ? R0 : -a1) - k : -a1 - k;
    let high = isForeign ? Math.max(R1, this.inField ? R1 : 0) : 0;
    let low = lowPull;
    if (isForeign && this.winds.length > 0) {
      const c = cos(this.rect.delta);
      const s = sin(this.rect.delta);
      const xm = Math.max(-this.windX0, this.windX1);
      const ym = Math.max(-this.windY0, this.windY1);
      low += Math.min(this.windX0, this.windX0 * c) - ym * s;
      high += Math.max(this.windX1, this.windX1 * c) + ym * s;
      T0 += Math.min(this.windY0, this.windY0 * c) - xm * s;
      T1 += Math.max(this.windY1, this.windY1 * c) + xm * s;
    }
    // momentum
    let n0 = l0;
    let n1 = l1;
    if (isForeign) {
      n0 += h * Math.min(0, T0 * e1, T0 * e0);
      n1 += h * Math.max(0, T1 * e1, T1 * e0);
      const s = this.slackL(Math.max(-n0, n1));
      n0 -= s;
      n1 += s;
    }
    m = Math.max(-n0, n1);
    const sq1 = m * m;
    const sq0 = n0 > 0 ? n0 * n0 : n1 < 0 ? n1 * n1 : 0;
    c1 = sq1 / (e0 * e0 * e0);
    const c0 = sq0 / (e1 * e1 * e1);
    const lowEnd = d0 + w0 * h + 0.5 * Math.min(0, c0 + low) * h * h;
    const highEnd = d1 + w1 * h + 0.5 * Math.max(0, c1 + high) * h * h;
    const lo1 = Math.max(lowEnd, e0);
    const hi1 = highEnd;
    const cInt1 = (sq1 * h * (d0 + lo1)) / (2 * d0 * d0 * lo1 * lo1);
    const cInt0 = (sq0 * h * (d1 + hi1)) / (2 * d1 * d1 * hi1 * hi1);
    const inv1 = h / (d0 * lo1);
    const inv0 = h / (d1 * hi1);
    let lowV = h * low;
    if (!isForeign) lowV = -h * (Math.max(0, pull * (1 - (d0 + lo1) / (2 * range))) + k);
    box[0] = d0 + w0 * h + 0.5 * (c0 + low) * h * h - SLACK;
    box[1] = d1 + w1 * h + 0.5 * (c1 + high) * h * h + SLACK;
    box[2] = t0 + (n0 >= 0 ? n0 * inv0 : n0 * inv1) - 1e-8;
    box[3] = t1 + (n1 >= 0 ? n1 * inv1 : n1 * inv0) + 1e-8;
    box[4] = w0 + cInt0 + lowV - SLACK;
    box[5] = w1 + cInt1 + h * high + SLACK;
    box[8] = n0;
    box[9] = n1;
    if (isForeign) {
      const more = h * v * (A + strongest);
      box[10] -= more;
      box[11] += more;
    } else {
      const a = -lowV;
      box[10] -= Math.max(0, a * (w1 + Math.max(0, h * c1))) + 1e-4;
      box[11] += Math.max(0, -a * (w0 + Math.min(0, h * (c0 + low)))) + 1e-4;
    }
    if (box[0] < 2) box[0] = 2;
    return true;
  }

  private moveNear(i: number): boolean {
    const { box, h, rocks, setting } = this;
    const [x0, x1, y0, y1, u0, u1, v0, v1, l0, l1] = box;
    const k = rocks[i].k;
    const { pull } = setting.rules;
    const { range } = setting.level;
    const A = setting.strongest + k;
    const square = mostSquare(u0, u1) + mostSquare(v0, v1);
    if (Math.min(2 * box[11], square) > this.fastest * this.fastest) {
      this.why = 'she may be too fast';
      return false;
    }
    const bend = 0.5 * A * h * h;
    this.rect.plain(
      Math.min(x0, x0 + h * u0 - bend),
      Math.max(x1, x1 + h * u1 + bend),
      Math.min(y0, y0 + h * v0 - bend),
      Math.max(y1, y1 + h * v1 + bend),
    );
    if (!this.isClear(i)) return false;
    this.windX0 = this.windX1 = this.windY0 = this.windY1 = 0;
    this.forces(i, false);
    let { ax0, ax1, ay0, ay1 } = this;
    const isForeign = this.foreign;
    const { X0, X1, Y0, Y1 } = this.rect;
    const dx = Math.max(0, X0, -X1);
    const dy = Math.max(0, Y0, -Y1);
    const near = Math.sqrt(dx * dx + dy * dy);
    const far = this.rect.farthest();
    const strength = this.inField ? 0 : pull;
    if (near < 0.5) {
      const a = strength + k;
      ax0 = Math.min(ax0, -a);
      ax1 = Math.max(ax1, a);
      ay0 = Math.min(ay0, -a);
      ay1 = Math.max(ay1, a);
    } else {
      const g1 = Math.max(0, strength * (1 / near - 1 / range) + k / near);
      const own = [Math.min(0, -X1 * g1), Math.max(0, -X0 * g1), Math.min(0, -Y1 * g1), Math.max(0, -Y0 * g1)];
      const cap = strength + k;
      for (let n = 0; n < 4; n++) own[n] = Math.max(-cap, Math.min(cap, own[n]));
      if (this.inField) {
        ax0 += own[0];
        ax1 += own[1];
        ay0 += own[2];
        ay1 += own[3];
      } else {
        // The recoil of a field's push acts together with it.
        const more = this.fields.length > 0 && isForeign ? k : 0;
        ax0 = Math.min(ax0 - more, own[0]);
        ax1 = Math.max(ax1 + more, own[1]);
        ay0 = Math.min(ay0 - more, own[2]);
        ay1 = Math.max(ay1 + more, own[3]);
      }
    }
    ax0 += this.windX0;
    ax1 += this.windX1;
    ay0 += this.windY0;
    ay1 += this.windY1;
    let n0 = l0;
    let n1 = l1;
    if (isForeign) {
      const dl = h * far * setting.strongest;
      n0 -= dl;
      n1 += dl;
    }
    const gu = h * A;
    const xu0 = Math.min(X0 * (u0 - gu), X0 * (u1 + gu), X1 * (u0 - gu), X1 * (u1 + gu));
    const xu1 = Math.max(X0 * (u0 - gu), X0 * (u1 + gu), X1 * (u0 - gu), X1 * (u1 + gu));
    const yv0 = Math.min(Y0 * (v0 - gu), Y0 * (v1 + gu), Y1 * (v0 - gu), Y1 * (v1 + gu));
    const yv1 = Math.max(Y0 * (v0 - gu), Y0 * (v1 + gu), Y1 * (v0 - gu), Y1 * (v1 + gu));
    const fastest = Math.sqrt(square) + h * A;
    let gain = h * fastest * (A + (isForeign ? setting.strongest : 0));
    let loss = gain;
    if (!isForeign && near >= 0.5) {
      const g1 = Math.max(0, pull * (1 / near - 1 / range) + k / near);
      loss = Math.min(loss, h * g1 * Math.max(0, xu1 + yv1));
      gain = Math.min(gain, h * g1 * Math.max(0, -xu0 - yv0));
    }
    box[10] -= loss + 1e-4;
    box[11] += gain + 1e-4;
    const half = 0.5 * h * h;
    box[0] = x0 + h * u0 + half * ax0 - SLACK;
    box[1] = x1 + h * u1 + half * ax1 + SLACK;
    box[2] = y0 + h * v0 + half * ay0 - SLACK;
    box[3] = y1 + h * v1 + half * ay1 + SLACK;
    box[4] = u0 + h * ax0 - SLACK;
    box[5] = u1 + h * ax1 + SLACK;
    box[6] = v0 + h * ay0 - SLACK;
    box[7] = v1 + h * ay1 + SLACK;
    box[8] = n0;
    box[9] = n1;
    return true;
  }

  // ---------------------------------------------------------------- cells
  private putPolar(layer: Layer, i: number, box: Float64Array, final: boolean): boolean {
    const { part, turn, turns, grid, radix } = this;
    const { place, speed, momentum } = grid;
    const a1 = Math.floor(box[1] / place);
    const b1 = Math.floor(box[3] / turn);
    const c0 = Math.floor(box[4] / speed);
    const c1 = Math.floor(box[5] / speed);
    const l0 = Math.floor(box[8] / momentum);
    const l1 = Math.floor(box[9] / momentum);
    if (
      c0 + radix[2] / 2 < 0 ||
      c1 + radix[2] / 2 >= radix[2] ||
      l0 + radix[4] / 2 < 0 ||
      l1 + radix[4] / 2 >= radix[4] ||
      a1 >= radix[0]
    ) {
      this.why = 'a box is off the grid';
      return false;
    }
    for (let a = Math.max(0, Math.floor(box[0] / place)); a <= a1; a++) {
      const d0 = Math.max(box[0], a * place);
      const d1 = Math.min(box[1], (a + 1) * place);
      for (let b = Math.floor(box[2] / turn); b <= b1; b++) {
        const t0 = Math.max(box[2], b * turn);
        const t1 = Math.min(box[3], (b + 1) * turn);
        this.rect.sector(d0, d1, t0, t1);
        this.setting.budget.look((2 + this.hazards.length) / 8 + ((c1 - c0 + 1) * (l1 - l0 + 1)) / 4);
        if (this.isDead(i, d1) || (final && !this.mayBeNearest(i))) continue;
        const whole = Math.floor(b / turns);
        const back = whole * 2 * Math.PI;
        const bb = b - whole * turns;
        for (let c = c0; c <= c1; c++) {
          for (let l = l0; l <= l1; l++) {
            part[0] = d0;
            part[1] = d1;
            part[2] = t0 - back;
            part[3] = t1 - back;
            part[4] = Math.max(box[4], c * speed);
            part[5] = Math.min(box[5], (c + 1) * speed);
            part[6] = 0;
            part[7] = 0;
            part[8] = Math.max(box[8], l * momentum);
            part[9] = Math.min(box[9], (l + 1) * momentum);
            part[10] = box[10];
            part[11] = box[11];
            if (!agree(part)) continue;
            const key =
              (((2 * i * radix[0] + a) * radix[1] + bb) * radix[2] + c + radix[2] / 2) * radix[3] * radix[4] + l + radix[4] / 2;
            layer.join(key, 2 * i, this.mark, part);
          }
        }
      }
    }
    return true;
  }

  private putNear(layer: Layer, i: number, box: Float64Array, final: boolean): boolean {
    const { part, grid, radix } = this;
    const { place, speed } = grid;
    const ra = radix[0] / 2;
    const rb = Math.floor(radix[1] / 2);
    const rc = radix[2] / 2;
    const a1 = Math.floor(box[1] / place);
    const b1 = Math.floor(box[3] / place);
    const c1 = Math.floor(box[5] / speed);
    const e1 = Math.floor(box[7] / speed);
    const first = [
      Math.floor(box[0] / place),
      Math.floor(box[2] / place),
      Math.floor(box[4] / speed),
      Math.floor(box[6] / speed),
    ];
    if (first[0] < -ra || first[1] < -rb || first[2] < -rc || first[3] < -rc || a1 >= ra || b1 >= rb || c1 >= rc || e1 >= rc) {
      this.why = 'a box is off the grid';
      return false;
    }
    for (let a = first[0]; a <= a1; a++) {
      const x0 = Math.max(box[0], a * place);
      const x1 = Math.min(box[1], (a + 1) * place);
      for (let b = first[1]; b <= b1; b++) {
        const y0 = Math.max(box[2], b * place);
        const y1 = Math.min(box[3], (b + 1) * place);
        this.rect.plain(x0, x1, y0, y1);
        this.setting.budget.look((2 + this.hazards.length) / 8 + ((c1 - first[2] + 1) * (e1 - first[3] + 1)) / 2);
        if (this.isDead(i, this.rect.farthest()) || (final && !this.mayBeNearest(i))) continue;
        for (let c = first[2]; c <= c1; c++) {
          const u0 = Math.max(box[4], c * speed);
          const u1 = Math.min(box[5], (c + 1) * speed);
          for (let e = first[3]; e <= e1; e++) {
            const v0 = Math.max(box[6], e * speed);
            const v1 = Math.min(box[7], (e + 1) * speed);
            // L = x v - y u
            const p0 = Math.min(x0 * v0, x0 * v1, x1 * v0, x1 * v1) - Math.max(y0 * u0, y0 * u1, y1 * u0, y1 * u1) - 1e-4;
            const p1 = Math.max(x0 * v0, x0 * v1, x1 * v0, x1 * v1) - Math.min(y0 * u0, y0 * u1, y1 * u0, y1 * u1) + 1e-4;
            const l0 = Math.max(box[8], p0);
            const l1 = Math.min(box[9], p1);
            if (l0 > l1) continue;
            part[0] = x0;
            part[1] = x1;
            part[2] = y0;
            part[3] = y1;
            part[4] = u0;
            part[5] = u1;
            part[6] = v0;
            part[7] = v1;
            part[8] = l0;
            part[9] = l1;
            part[10] = Math.max(box[10], (leastSquare(u0, u1) + leastSquare(v0, v1)) / 2 - 1e-4);
            part[11] = Math.min(box[11], (mostSquare(u0, u1) + mostSquare(v0, v1)) / 2 + 1e-4);
            if (part[10] > part[11]) continue;
            const key = ((((2 * i + 1) * radix[0] + a + ra) * radix[1] + b + rb) * radix[2] + c + rc) * radix[3] + e + rc;
            layer.join(key * radix[4], 2 * i + 1, this.mark, part);
          }
        }
      }
    }
    return true;
  }

  /** Sorts the boxes after a step into the charts of the asteroids that may be nearest. */
  private settle(next: Layer): boolean {
    const { raw, box, rocks } = this;
    const { range } = this.setting.level;
    for (let b = 0; b < raw.size; b++) {
      for (let n = 0, o = b * NUMBERS; n < NUMBERS; n++, o++) box[n] = raw.boxes[o];
      const chart = raw.charts[b];
      const i = chart >> 1;
      const isPolar = chart % 2 === 0;
      for (let j = 0; j < rocks.length; j++) {
        if (j === i) continue;
        this.rectOf(box, isPolar);
        if ((raw.marks[b] & (1 << (j & 31))) === 0 || !this.mayBeNearer(i, j)) continue;
        if (isPolar ? !this.convertParts(box, i, j, next) : !this.convert(box, chart, j, next)) return false;
      }
      this.rectOf(box, isPolar);
      const near = isPolar ? box[0] : this.rect.nearest();
      if (near > range + SLACK) {
        this.endedBy.add(RANGE);
        continue;
      }
      if (rocks.length > 1 && !this.mayBeNearest(i)) continue;
      const border = this.border(box[8], box[9]);
      if (isPolar) {
        if (box[1] <= border ? !this.convert(box, chart, i, next) : !this.putPolar(next, i, box, true)) return false;
      } else if (near >= border ? !this.convert(box, chart, i, next) : !this.putNear(next, i, box, true)) return false;
    }
    return true;
  }

  /** Puts the parts of a box in polar coordinates from which another asteroid may be nearer into the charts of that one. */
  private convertParts(box: Float64Array, i: number, j: number, next: Layer): boolean {
    const { cut } = this;
    for (let n = 0; n < 8; n++) {
      cut.set(box);
      for (let k = 0; k < 3; k++) {
        const at = 2 * k;
        const middle = (box[at] + box[at + 1]) / 2;
        cut[at + 1 - ((n >> k) & 1)] = middle;
      }
      if (!agree(cut)) continue;
      this.rectOf(cut, true);
      if (this.mayBeNearer(i, j) && !this.convert(cut, 2 * i, j, next)) return false;
    }
    return true;
  }

  private border(l0: number, l1: number): number {
    const m = (Math.abs(l0) + Math.abs(l1)) / 2;
    return Math.max(INNER, Math.sqrt(m / QUICK));
  }

  private rectOf(box: Float64Array, isPolar: boolean): void {
    if (isPolar) this.rect.sector(box[0], box[1], box[2], box[3]);
    else this.rect.plain(box[0], box[1], box[2], box[3]);
  }

  // ---------------------------------------------------------------- conversion
  /** The velocity of a box along axes turned by beta, relative to the box's asteroid. */
  private velocity(box: Float64Array, isPolar: boolean, beta: number): void {
    this.measureVelocity(box, isPolar, beta);
    // Near a centre the quotient of momentum and distance may be far greater than she is fast.
    const fast = Math.sqrt(2 * box[11]) + SLACK;
    this.vx0 = Math.max(this.vx0, -fast);
    this.vx1 = Math.min(this.vx1, fast);
    this.vy0 = Math.max(this.vy0, -fast);
    this.vy1 = Math.min(this.vy1, fast);
  }

  private measureVelocity(box: Float64Array, isPolar: boolean, beta: number): void {
    if (isPolar) {
      const mid = (box[2] + box[3]) / 2;
      const s = sin(Math.min(Math.PI / 2, (box[3] - box[2]) / 2));
      const q = 1 - cos(Math.min(Math.PI, (box[3] - box[2]) / 2));
      const c = cos(mid - beta);
      const t = sin(mid - beta);
      const p0 = box[8] >= 0 ? box[8] / box[1] : box[8] / box[0];
      const p1 = box[9] >= 0 ? box[9] / box[0] : box[9] / box[1];
      const x0 = Math.min(box[4] * c, box[5] * c) - Math.max(p0 * t, p1 * t);
      const x1 = Math.max(box[4] * c, box[5] * c) - Math.min(p0 * t, p1 * t);
      const y0 = Math.min(box[4] * t, box[5] * t) + Math.min(p0 * c, p1 * c);
      const y1 = Math.max(box[4] * t, box[5] * t) + Math.max(p0 * c, p1 * c);
      const xm = Math.max(-x0, x1);
      const ym = Math.max(-y0, y1);
      this.vx0 = x0 - ym * s - xm * q - SLACK;
      this.vx1 = x1 + ym * s + xm * q + SLACK;
      this.vy0 = y0 - xm * s - ym * q - SLACK;
      this.vy1 = y1 + xm * s + ym * q + SLACK;
      return;
    }
    const c = cos(beta);
    const t = sin(beta);
    this.vx0 = Math.min(box[4] * c, box[5] * c) + Math.min(box[6] * t, box[7] * t) - SLACK;
    this.vx1 = Math.max(box[4] * c, box[5] * c) + Math.max(box[6] * t, box[7] * t) + SLACK;
    this.vy0 = Math.min(box[6] * c, box[7] * c) - Math.max(box[4] * t, box[5] * t) - SLACK;
    this.vy1 = Math.max(box[6] * c, box[7] * c) - Math.min(box[4] * t, box[5] * t) + SLACK;
  }

  private toNear(box: Float64Array, i: number): void {
    this.fill(box, 2 * i, i, true);
    box.set(this.made);
  }

  /** Puts a box of a chart into the charts of asteroid j. */
  private convert(box: Float64Array, chart: number, j: number, layer: Layer): boolean {
    const polar = this.fill(box, chart, j, false);
    if (polar === null) return true;
    return polar ? this.putPolar(layer, j, this.made, true) : this.putNear(layer, j, this.made, true);
  }

  /** Writes the box as one about asteroid j to `made`; whether it is polar, null when it is empty. */
  private fill(box: Float64Array, chart: number, j: number, nearOnly: boolean): boolean | null {
    const { made, rocks } = this;
    const i = chart >> 1;
    const isPolar = chart % 2 === 0;
    this.rectOf(box, isPolar);
    const D = i === j ? SLACK : this.drift[i] + this.drift[j] + SLACK;
    const V = i === j ? 0 : this.shift[i] + this.shift[j];
    const ox = rocks[i].x - rocks[j].x;
    const oy = rocks[i].y - rocks[j].y;
    // The rectangle about j, in its own frame.
    const { alpha, ca, sa } = this.rect;
    const x = ox * ca + oy * sa;
    const y = oy * ca - ox * sa;
    const X0 = this.rect.X0 + x - D;
    const X1 = this.rect.X1 + x + D;
    const Y0 = this.rect.Y0 + y - D;
    const Y1 = this.rect.Y1 + y + D;
    const farY = this.rect.farthest();
    // Momentum
    let l0 = box[8];
    let l1 = box[9];
    if (i !== j) {
      const o = Math.sqrt(ox * ox + oy * oy);
      this.velocity(box, isPolar, atan2(oy, ox));
      const speed = Math.max(-this.vx0, this.vx1) + Math.max(-this.vy0, this.vy1);
      const more = farY * V + (o + D) * V + D * speed + 1e-4;
      l0 += o * this.vy0 - more;
      l1 += o * this.vy1 + more;
    }
    const dx = Math.max(0, X0, -X1);
    const dy = Math.max(0, Y0, -Y1);
    // Energy
    const fast = Math.sqrt(2 * box[11]);
    made[10] = box[10] - V * fast - 1e-4;
    made[11] = box[11] + V * fast + V * V + 1e-4;
    let near = Math.sqrt(dx * dx + dy * dy);
    const fx = Math.max(-X0, X1);
    const fy = Math.max(-Y0, Y1);
    let far = Math.sqrt(fx * fx + fy * fy);
    if (i === j && isPolar) {
      near = box[0];
      far = box[1];
    }
    const border = this.border(l0, l1);
    const mid = (near + far) / 2;
    if (!nearOnly && near > 6 && mid > border) {
      if (near > this.setting.level.range) return null;
      // Direction
      const beta = atan2((Y0 + Y1) / 2, (X0 + X1) / 2);
      const cb = cos(beta);
      const sb = sin(beta);
      let delta = 0;
      for (let n = 0; n < 4; n++) {
        const px = n & 1 ? X1 : X0;
        const py = n & 2 ? Y1 : Y0;
        const along = px * cb + py * sb;
        const across = Math.abs(py * cb - px * sb);
        delta = Math.max(delta, atan2(across, along));
      }
      if (delta < 1.5) {
        this.velocity(box, isPolar, alpha + beta);
        const c = cos(delta);
        const s = sin(delta);
        const ym = Math.max(-this.vy0, this.vy1) + V;
        const vx0 = this.vx0 - V;
        const vx1 = this.vx1 + V;
        made[0] = near;
        made[1] = far;
        made[2] = alpha + beta - delta - 1e-8;
        made[3] = alpha + beta + delta + 1e-8;
        made[4] = Math.min(vx0, vx0 * c) - ym * s;
        made[5] = Math.max(vx1, vx1 * c) + ym * s;
        made[6] = 0;
        made[7] = 0;
        // v tangential = L / d
        const xm = Math.max(-vx0, vx1);
        const p0 = Math.min(this.vy0 - V, (this.vy0 - V) * c) - xm * s;
        const p1 = Math.max(this.vy1 + V, (this.vy1 + V) * c) + xm * s;
        made[8] = Math.max(l0, Math.min(p0 * near, p0 * far) - 1e-4);
        made[9] = Math.min(l1, Math.max(p1 * near, p1 * far) + 1e-4);
        return made[8] <= made[9] ? true : null;
      }
    }
    // Cartesian, along the level's axes.
    const xs = [X0 * ca - Y0 * sa, X1 * ca - Y0 * sa, X0 * ca - Y1 * sa, X1 * ca - Y1 * sa];
    const ys = [X0 * sa + Y0 * ca, X1 * sa + Y0 * ca, X0 * sa + Y1 * ca, X1 * sa + Y1 * ca];
    this.velocity(box, isPolar, 0);
    made[0] = Math.min(...xs);
    made[1] = Math.max(...xs);
    made[2] = Math.min(...ys);
    made[3] = Math.max(...ys);
    made[4] = this.vx0 - V;
    made[5] = this.vx1 + V;
    made[6] = this.vy0 - V;
    made[7] = this.vy1 + V;
    made[8] = l0;
    made[9] = l1;
    return false;
  }
}

const least = (v: number, g0: number, g1: number): number => Math.min(v * g0, v * g1);
const greatest = (v: number, g0: number, g1: number): number => Math.max(v * g0, v * g1);

import { TICK } from '../../../engine/index.ts';
import { driftAfter, isEasyFor } from '../assumptions.ts';
import type { About, Blocker, OrbitGrid } from '../proof.ts';
import { distance } from '../rounding.ts';
import type { Setting, Thing } from '../setting.ts';
import { agree, leastSquare, mostSquare } from './agree.ts';
import { Layer, NUMBERS } from './layer.ts';
import { Moves } from './moves.ts';
import { orbitScene } from './scene.ts';
import { SLACK, slackL } from './slack.ts';
import type { OrbitWatch } from './watch.ts';

/** In a part of a step, distance changes by about this share of itself, or direction by this many rad. */
const BEND = 0.12;
/** Length of a part near the centre, s. */
const NEAR_PART = 0.1;
const MOST_PARTS = 8;
/** It gives up after this much work for each box that it may follow, looks: where boxes grow large, each is cut into thousands. */
const LOOKS_A_BOX = 60;
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
  const fan = new OrbitFan(setting, about, goal, grid, watch, setting.budget.looks + LOOKS_A_BOX * most.boxes);
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

class OrbitFan extends Moves {
  readonly endedBy = new Set<Blocker>();
  private readonly grid: OrbitGrid;
  private readonly mostLooks: number;
  /** Length of a step, s. */
  private readonly step: number;
  private readonly turns: number;
  private readonly turn: number;
  private readonly radix: readonly number[];
  private readonly raw = new Layer();
  private readonly part = new Float64Array(NUMBERS);
  private readonly cut = new Float64Array(NUMBERS);

  constructor(setting: Setting, about: About, goal: Thing, grid: OrbitGrid, watch: OrbitWatch, mostLooks: number) {
    super(setting, orbitScene(setting, about, goal), watch);
    this.grid = grid;
    this.mostLooks = mostLooks;
    this.step = grid.frames * TICK;
    this.turns = Math.max(4, Math.round((2 * Math.PI * 100) / grid.place));
    this.turn = (2 * Math.PI) / this.turns;
    const reach = setting.level.range + this.fastest * this.step;
    const cells = 2 * Math.ceil(reach / grid.place) + 4;
    const speeds = 2 * Math.ceil(this.fastest / grid.speed) + 4;
    const momenta = 2 * Math.ceil((1.5 * reach * this.fastest) / grid.momentum) + 4;
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
      const s = slackL(L);
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

  advance(now: Layer, step: number, next: Layer): boolean {
    const { raw, box, rocks, setting } = this;
    const time = step * this.step;
    this.drift = rocks.map((_, i) => driftAfter(setting, i, time));
    this.shift = rocks.map(({ k }) => k * (time + TICK));
    raw.clear();
    const cost = 8 + 2 * rocks.length + this.scene.fields.length + 2 * this.scene.hazards.length;
    for (let b = 0; b < now.size; b++) {
      setting.budget.look(cost / 8);
      for (let n = 0, o = b * NUMBERS; n < NUMBERS; n++, o++) box[n] = now.boxes[o];
      const chart = now.charts[b];
      if (!this.move(chart >> 1, chart % 2 === 0) || this.isTooMuch()) return false;
    }
    return this.settle(next);
  }

  private isTooMuch(): boolean {
    if (this.setting.budget.looks <= this.mostLooks) return false;
    this.why = 'boxes have too many parts';
    return true;
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
    this.setting.budget.look(parts * (1 + this.rocks.length / 4 + this.scene.hazards.length / 8));
    for (let n = 0; n < parts; n++) {
      if (!(this.isPolar ? this.movePolar(i) : this.moveNear(i))) return false;
      if (this.isPolar && !agree(box)) return true;
    }
    return this.isPolar ? this.putPolar(this.raw, i, box, false) : this.putNear(this.raw, i, box, false);
  }

  private isDead(i: number, d1: number): boolean {
    const { rocks } = this;
    const own = this.scene.own[i];
    if (own !== null && d1 < rocks[i].radius + this.setting.leastHalf - SLACK) {
      this.endedBy.add(own);
      return true;
    }
    for (const hazard of this.scene.hazards) {
      if (this.far(i, hazard) + this.drift[i] >= hazard.r - SLACK) continue;
      this.endedBy.add(hazard.of);
      return true;
    }
    return false;
  }

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
        this.setting.budget.look((2 + this.scene.hazards.length) / 8 + ((c1 - c0 + 1) * (l1 - l0 + 1)) / 4);
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
        this.setting.budget.look((2 + this.scene.hazards.length) / 8 + ((c1 - first[2] + 1) * (e1 - first[3] + 1)) / 2);
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
      if (this.isTooMuch()) return false;
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

  /** Puts a box of a chart into the charts of asteroid j. */
  private convert(box: Float64Array, chart: number, j: number, layer: Layer): boolean {
    const polar = this.fill(box, chart, j, false);
    if (polar === null) return true;
    return polar ? this.putPolar(layer, j, this.made, true) : this.putNear(layer, j, this.made, true);
  }
}

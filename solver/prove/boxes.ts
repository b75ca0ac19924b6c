import { TICK } from '../../engine/index.ts';
import { bendWithin, driftAfter, easySpeed, isEasyFor, recoilBlur } from './assumptions.ts';
import { standingCircles } from './blockers.ts';
import type { About, Blocker, BoxNumbers, FanGrid } from './proof.ts';
import { mouthDiscs, RIM_SLACK, type Setting, type Spot, type Thing } from './setting.ts';

/** A box of places and velocities: least and greatest of x, y, vx, vy, px and px/s, along the grid's axes. */
type FlatBox = [number, number, number, number, number, number, number, number];

const RANGE: Blocker = { kind: 'range' };

/** Every bound is rounded outwards by this in each step, px and px/s. */
const SLACK = 1e-6;

/** Bounds are then rounded to whole millionths, which are short to write down. */
const PARTS = 1e6;
const down = (v: number): number => Math.floor((v - SLACK) * PARTS) / PARTS;
const up = (v: number): number => Math.ceil((v + SLACK) * PARTS) / PARTS;

/** Everything that she may do from the start, as far as it was followed. */
export interface BoxesResult {
  /** Every run has ended, and none came near the object. */
  readonly closed: boolean;
  /** The sets of states that are still going on: at the start, and after each complete step. */
  readonly layers: readonly (readonly BoxNumbers[])[];
  /** What ended runs; `range` stands for the end of the range. */
  readonly endedBy: readonly Blocker[];
  /** The squares through which she may come: their lower left corners along the grid's axes, px. */
  readonly squares: readonly { readonly x: number; readonly y: number }[];
}

/**
 * Computes the reachable set from the start, step by step: boxes of place and velocity that contain every run, whatever is
 * pressed. A box that lies entirely in a hazard or out of range has ended. It gives up when a box comes near the object, or
 * after the given number of steps or boxes.
 */
export function followBoxes(
  setting: Setting,
  about: About,
  goal: Thing,
  grid: FanGrid,
  most: { readonly steps: number; readonly boxes: number },
): BoxesResult {
  const reach = new BoxReach(setting, about, goal, grid);
  const layers: BoxNumbers[][] = [];
  let layer = reach.start();
  let boxes = 0;
  let near = false;
  while (layer.size > 0 && !near && boxes <= most.boxes && layers.length < most.steps) {
    layers.push([...layer.values()]);
    const next = new Map<number, FlatBox>();
    for (const box of layer.values()) {
      near = !reach.advance(box, layers.length * grid.frames * TICK, next);
      if (near) break;
    }
    boxes += next.size;
    layer = next;
  }
  const closed = !near && layer.size === 0 && reach.isEasy();
  return { closed, layers, endedBy: [...reach.endedBy], squares: [...reach.squares.values()] };
}

class BoxReach {
  private readonly setting: Setting;
  private readonly grid: FanGrid;
  private readonly step: number;
  private readonly goal: Spot;
  private readonly hazards: readonly (Spot & { readonly of: Blocker })[];
  private readonly asteroids: readonly Spot[];
  private readonly fields: readonly Spot[];
  private readonly winds: readonly (Spot & { readonly a: readonly [number, number] })[];
  private readonly mouths: readonly Spot[];
  private readonly a = new Float64Array(4);
  private readonly blur: number;
  /** How much later her velocity may follow a push than her place, s: a frame where frames are followed, too. */
  private readonly lag: number;
  /** The greatest acceleration at any accuracy, px/s². */
  private readonly strongest: number;
  readonly endedBy = new Set<Blocker>();
  readonly squares = new Map<number, { x: number; y: number }>();

  constructor(setting: Setting, about: About, goal: Thing, grid: FanGrid) {
    const { level } = setting;
    this.setting = setting;
    this.grid = grid;
    this.step = grid.frames * TICK;
    this.blur = recoilBlur(setting);
    this.lag = setting.jump > 0 ? TICK : 0;
    this.strongest = setting.strongest + this.blur;
    const [ux, uy] = grid.axis;
    const turned = ({ x, y }: { x: number; y: number }, r: number): Spot => ({ x: x * ux + y * uy, y: y * ux - x * uy, r });
    const place = ({ x, y }: { x: number; y: number }) => ({ x: x - level.astronaut.x, y: y - level.astronaut.y });
    this.goal = turned(goal, goal.touch);
    this.hazards = standingCircles(setting, about).map((c) => ({ ...turned(c, c.radius + setting.leastHalf), of: c.of }));
    this.asteroids = level.asteroids.map((c) => turned(place(c), level.range));
    this.fields = level.repulsors.map((c) => turned(place(c), c.radius));
    this.winds = level.winds.map((c) => {
      const { x, y } = turned({ x: c.ax, y: c.ay }, 0);
      return { ...turned(place(c), c.radius), a: [x, y] };
    });
    this.mouths = mouthDiscs(level).map((c) => turned(place(c), c.radius));
  }

  /** Whether she stays below the speed limit throughout every step. */
  isEasy(): boolean {
    const { level, rules } = this.setting;
    return isEasyFor({ level, rules, strongest: this.strongest }, this.step);
  }

  start(): Map<number, FlatBox> {
    const { vx, vy } = this.setting.level.astronaut;
    const [ux, uy] = this.grid.axis;
    const v = { x: vx * ux + vy * uy, y: vy * ux - vx * uy };
    const layer = new Map<number, FlatBox>();
    this.put(layer, [down(0), up(0), down(0), up(0), down(v.x), up(v.x), down(v.y), up(v.y)], 0);
    return layer;
  }

  private drift(i: number, time: number): number {
    return driftAfter(this.setting, i, time);
  }

  /**
   * Adds everything that a box becomes in a step that ends at `time` to `next`. Returns false when it comes near the object.
   *
   * In frames her velocity follows a push a frame later than its place. So a step has the pushes at places from a frame before it
   * on, and the first step has a frame's push less, because nothing pushed before.
   */
  advance(box: FlatBox, time: number, next: Map<number, FlatBox>): boolean {
    const { step, a } = this;
    const isFirst = time <= step;
    const before = isFirst ? 0 : this.lag;
    this.setting.budget.look(4 + 2 * this.asteroids.length + this.fields.length);
    // All places within the step.
    const bend = bendWithin(this.strongest, step * (step + TICK)) + SLACK;
    const xa = box[0] + Math.min(0, step * box[4]) - bend;
    const xb = box[1] + Math.max(0, step * box[5]) + bend;
    const ya = box[2] + Math.min(0, step * box[6]) - bend;
    const yb = box[3] + Math.max(0, step * box[7]) + bend;
    if (nearestTo(this.goal, xa, xb, ya, yb) <= this.goal.r + SLACK) return false;
    for (const mouth of this.mouths) if (nearestTo(mouth, xa, xb, ya, yb) <= mouth.r + RIM_SLACK) return false;
    const xm = Math.min(xa, box[0] - before * box[5] - SLACK);
    const xn = Math.max(xb, box[1] - before * box[4] + SLACK);
    const ym = Math.min(ya, box[2] - before * box[7] - SLACK);
    const yn = Math.max(yb, box[3] - before * box[6] + SLACK);
    this.accelerations(xm, xn, ym, yn, time);
    this.blow(xm, xn, ym, yn);
    for (let n = 0; n < 4; n++) a[n] += n % 2 === 0 ? -this.blur : this.blur;
    // The term a t² / 2. Frames push before they move, so there is half a frame's push more, and in the first step one less.
    const less = 0.5 * step * (step - TICK);
    const more = 0.5 * step * (step + TICK);
    const low = (v: number) => Math.min(v * less, v * more);
    const high = (v: number) => Math.max(v * less, v * more);
    const least = isFirst ? step - this.lag : step;
    const slowest = (v: number) => Math.min(v * least, v * step);
    const fastest = (v: number) => Math.max(v * least, v * step);
    const moved: FlatBox = [
      down(box[0] + box[4] * step + low(a[0])),
      up(box[1] + box[5] * step + high(a[1])),
      down(box[2] + box[6] * step + low(a[2])),
      up(box[3] + box[7] * step + high(a[3])),
      down(box[4] + slowest(a[0])),
      up(box[5] + fastest(a[1])),
      down(box[6] + slowest(a[2])),
      up(box[7] + fastest(a[3])),
    ];
    if (Math.max(-moved[4], moved[5], -moved[6], moved[7]) > easySpeed(this.setting.rules)) return false;
    this.put(next, moved, time);
    return true;
  }

  /** Divides a box along the grid, and adds the parts that have not ended to the layer, joined with what is there. */
  private put(layer: Map<number, FlatBox>, box: FlatBox, time: number): void {
    const { cell, bin } = this.grid;
    for (let i = Math.floor(box[0] / cell); i * cell <= box[1]; i++) {
      const xa = Math.max(box[0], i * cell);
      const xb = Math.min(box[1], (i + 1) * cell);
      for (let j = Math.floor(box[2] / cell); j * cell <= box[3]; j++) {
        const ya = Math.max(box[2], j * cell);
        const yb = Math.min(box[3], (j + 1) * cell);
        if (time > 0 && this.isOver(xa, xb, ya, yb, time)) continue;
        const square = i * 32768 + j;
        if (!this.squares.has(square)) this.squares.set(square, { x: i * cell, y: j * cell });
        for (let k = Math.floor(box[4] / bin); k * bin <= box[5]; k++) {
          const va = Math.max(box[4], k * bin);
          const vb = Math.min(box[5], (k + 1) * bin);
          for (let l = Math.floor(box[6] / bin); l * bin <= box[7]; l++) {
            const key = (((i + 16384) * 32768 + (j + 16384)) * 2048 + (k + 1024)) * 2048 + (l + 1024);
            const wa = Math.max(box[6], l * bin);
            const wb = Math.min(box[7], (l + 1) * bin);
            const there = layer.get(key);
            if (there === undefined) layer.set(key, [xa, xb, ya, yb, va, vb, wa, wb]);
            else {
              // most parts meet another one: no array for them
              if (xa < there[0]) there[0] = xa;
              if (xb > there[1]) there[1] = xb;
              if (ya < there[2]) there[2] = ya;
              if (yb > there[3]) there[3] = yb;
              if (va < there[4]) there[4] = va;
              if (vb > there[5]) there[5] = vb;
              if (wa < there[6]) there[6] = wa;
              if (wb > there[7]) there[7] = wb;
            }
          }
        }
      }
    }
  }

  /** Whether a rectangle lies entirely in one hazard, or out of range of everything. */
  private isOver(xa: number, xb: number, ya: number, yb: number, time: number): boolean {
    this.setting.budget.look(1 + this.hazards.length + this.asteroids.length);
    for (const hazard of this.hazards) {
      if (farthestFrom(hazard, xa, xb, ya, yb) >= hazard.r - SLACK) continue;
      this.endedBy.add(hazard.of);
      return true;
    }
    const lost = this.asteroids.every((rock, i) => nearestTo(rock, xa, xb, ya, yb) > rock.r + this.drift(i, time) + SLACK);
    if (lost) this.endedBy.add(RANGE);
    return lost;
  }

  /** Adds the accelerations of the winds that may blow, or certainly blow, within a rectangle. */
  private blow(xa: number, xb: number, ya: number, yb: number): void {
    const { a } = this;
    for (const wind of this.winds) {
      if (nearestTo(wind, xa, xb, ya, yb) > wind.r + RIM_SLACK) continue;
      const isIn = farthestFrom(wind, xa, xb, ya, yb) < wind.r - RIM_SLACK;
      for (const [axis, strength] of wind.a.entries()) {
        a[2 * axis] += isIn ? strength : Math.min(0, strength);
        a[2 * axis + 1] += isIn ? strength : Math.max(0, strength);
      }
    }
  }

  /** Writes the least and greatest acceleration within a rectangle to `a`, whatever is pressed. */
  private accelerations(xa: number, xb: number, ya: number, yb: number, time: number): void {
    const { a } = this;
    const { pull, push } = this.setting.rules;
    a.fill(0);
    let inField = false;
    let first = true;
    const include = (x0: number, x1: number, y0: number, y1: number) => {
      a[0] = first ? x0 : Math.min(a[0], x0);
      a[1] = first ? x1 : Math.max(a[1], x1);
      a[2] = first ? y0 : Math.min(a[2], y0);
      a[3] = first ? y1 : Math.max(a[3], y1);
      first = false;
    };
    for (const field of this.fields) {
      const near = nearestTo(field, xa, xb, ya, yb);
      if (near > field.r + SLACK) continue;
      const far = farthestFrom(field, xa, xb, ya, yb);
      if (far < field.r - SLACK) inField = true;
      if (near < 1) include(-push, push, -push, push);
      else {
        const g0 = push / far;
        const g1 = push / near;
        include(
          Math.max(-push, least(xa - field.x, g0, g1)),
          Math.min(push, greatest(xb - field.x, g0, g1)),
          Math.max(-push, least(ya - field.y, g0, g1)),
          Math.min(push, greatest(yb - field.y, g0, g1)),
        );
      }
    }
    if (inField) return;
    include(0, 0, 0, 0);
    const { range } = this.setting.level;
    let reach = Number.POSITIVE_INFINITY;
    for (const [i, rock] of this.asteroids.entries()) {
      reach = Math.min(reach, farthestFrom(rock, xa, xb, ya, yb) + this.drift(i, time));
    }
    for (const [i, rock] of this.asteroids.entries()) {
      const moved = this.drift(i, time);
      const near = nearestTo(rock, xa, xb, ya, yb) - moved;
      if (near > reach + SLACK) continue;
      if (near < 1) {
        include(-pull, pull, -pull, pull);
        continue;
      }
      // The pull is `pull` (1 / d - 1 / range) times the vector to the asteroid.
      const g0 = Math.max(0, pull * (1 / (farthestFrom(rock, xa, xb, ya, yb) + moved) - 1 / range));
      const g1 = Math.max(0, pull * (1 / near - 1 / range));
      include(
        Math.max(-pull, least(rock.x - moved - xb, g0, g1)),
        Math.min(pull, greatest(rock.x + moved - xa, g0, g1)),
        Math.max(-pull, least(rock.y - moved - yb, g0, g1)),
        Math.min(pull, greatest(rock.y + moved - ya, g0, g1)),
      );
    }
  }
}

const least = (v: number, g0: number, g1: number): number => Math.min(v * g0, v * g1);
const greatest = (v: number, g0: number, g1: number): number => Math.max(v * g0, v * g1);

function nearestTo({ x, y }: Spot, xa: number, xb: number, ya: number, yb: number): number {
  const dx = Math.max(0, xa - x, x - xb);
  const dy = Math.max(0, ya - y, y - yb);
  return Math.sqrt(dx * dx + dy * dy);
}

function farthestFrom({ x, y }: Spot, xa: number, xb: number, ya: number, yb: number): number {
  const dx = Math.max(x - xa, xb - x);
  const dy = Math.max(y - ya, yb - y);
  return Math.sqrt(dx * dx + dy * dy);
}

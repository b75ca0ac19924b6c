import { TICK } from '../../../engine/index.ts';
import { easySpeed, isEasyFor } from '../assumptions.ts';
import type { About, Blocker, OrbitGrid } from '../proof.ts';
import { distance } from '../rounding.ts';
import type { Setting, Thing } from '../setting.ts';
import { Cells } from './cells.ts';
import { Charts } from './charts.ts';
import { Forces } from './forces.ts';
import { agree, Layer, NUMBERS, type OrbitWatch } from './layer.ts';
import { Moves } from './moves.ts';
import { type OrbitScene, orbitScene, SLACK, slackL } from './scene.ts';

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
  const reach = new OrbitReach(setting, about, goal, grid, watch, setting.budget.looks + LOOKS_A_BOX * most.boxes);
  let boxes = 0;
  const end = (closed: boolean, steps: number, why: string): OrbitResult => ({
    closed,
    steps,
    boxes,
    why,
    endedBy: [...reach.endedBy],
  });
  if (!reach.fits() || !isEasyFor(setting, grid.frames * TICK)) return end(false, 0, 'the grid is too fine or she is too fast');
  // what she touches at the start counts, even if a hazard ends the run there
  if (distance(goal, { x: 0, y: 0 }) <= goal.touch + SLACK) return end(false, 0, 'the object is at the start');
  let now = new Layer();
  let next = new Layer();
  const off = reach.start(now);
  if (off !== null) return end(false, 0, off);
  for (let step = 0; step <= most.steps; step++) {
    watch.layer?.(now, step);
    if (now.size === 0) return end(true, step, '');
    boxes += now.size;
    if (boxes > most.boxes) return end(false, step, 'there are too many boxes');
    next.clear();
    const why = reach.advance(now, step + 1, next);
    if (why !== null) return end(false, step, why);
    [now, next] = [next, now];
  }
  return end(false, most.steps, 'runs go on');
}

class OrbitReach {
  private readonly setting: Setting;
  private readonly scene: OrbitScene;
  private readonly charts: Charts;
  private readonly forces: Forces;
  private readonly moves: Moves;
  private readonly cells: Cells;
  private readonly mostLooks: number;
  /** Length of a step, s. */
  private readonly step: number;
  /** What she may reach in the first step, px/s. It is below the speed limit (`isEasyFor`). */
  private readonly fastestAtFirst: number;
  private readonly raw = new Layer();
  private readonly box = new Float64Array(NUMBERS);
  private readonly cut = new Float64Array(NUMBERS);

  constructor(setting: Setting, about: About, goal: Thing, grid: OrbitGrid, watch: OrbitWatch, mostLooks: number) {
    this.setting = setting;
    this.scene = orbitScene(setting, about, goal);
    this.charts = new Charts(setting, this.scene);
    this.forces = new Forces(setting, this.scene, this.charts);
    this.moves = new Moves(setting, this.scene, this.charts, this.forces, watch);
    this.mostLooks = mostLooks;
    this.step = grid.frames * TICK;
    const { vx, vy } = setting.level.astronaut;
    const recoil = Math.max(0, ...this.scene.rocks.map(({ k }) => k));
    const gain = (setting.strongest + recoil) * (this.step + TICK);
    this.fastestAtFirst = Math.max(easySpeed(setting.rules), Math.sqrt(vx * vx + vy * vy) + gain);
    this.cells = new Cells(setting, this.scene, this.charts, grid, this.fastestAtFirst);
  }

  /** What ended runs so far. */
  get endedBy(): Set<Blocker> {
    return this.cells.endedBy;
  }

  fits(): boolean {
    return this.cells.fits();
  }

  /**
   * Puts the start into the charts of the asteroids that may be nearest.
   * @returns why it gave up; null when it did not
   */
  start(layer: Layer): string | null {
    const { vx, vy } = this.setting.level.astronaut;
    const made = new Float64Array(NUMBERS);
    for (const [i, rock] of this.scene.rocks.entries()) {
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
      const why = this.convert(made, 2 * i + 1, i, layer);
      if (why !== null) return why;
    }
    return null;
  }

  /**
   * Follows the boxes of a layer through a step, which is numbered from 1.
   * @returns why it gave up; null when it did not
   */
  advance(now: Layer, step: number, next: Layer): string | null {
    const { raw, scene, setting } = this;
    const { box } = this.moves;
    this.charts.until(step * this.step);
    this.moves.fastest = step === 1 ? this.fastestAtFirst : easySpeed(setting.rules);
    raw.clear();
    const cost = 8 + 2 * scene.rocks.length + scene.fields.length + 2 * scene.hazards.length;
    for (let b = 0; b < now.size; b++) {
      setting.budget.look(cost / 8);
      for (let n = 0, o = b * NUMBERS; n < NUMBERS; n++, o++) box[n] = now.boxes[o];
      const chart = now.charts[b];
      const why = this.move(chart >> 1, chart % 2 === 0) ?? this.whyTooMuch();
      if (why !== null) return why;
    }
    return this.sortIn(next);
  }

  private whyTooMuch(): string | null {
    return this.setting.budget.looks > this.mostLooks ? 'boxes have too many parts' : null;
  }

  /** Follows the present box through a step, in parts that are short where she turns quickly, and puts it into its cells. */
  private move(i: number, isPolar: boolean): string | null {
    const { cells, forces, moves, raw, scene } = this;
    const { box } = moves;
    forces.mark = 0;
    moves.isPolar = isPolar;
    const lm = Math.max(-box[8], box[9]);
    const rate = isPolar ? (lm / box[0] + Math.max(-box[4], box[5])) / box[0] / BEND : 1 / NEAR_PART;
    const parts = Math.max(1, Math.min(MOST_PARTS, Math.ceil(this.step * rate - 1e-9)));
    this.setting.budget.look(parts * (1 + scene.rocks.length / 4 + scene.hazards.length / 8));
    for (let n = 0; n < parts; n++) {
      const why = moves.part(i, this.step / parts);
      if (why !== null) return why;
      if (moves.isPolar && !agree(box)) return null;
    }
    return moves.isPolar ? cells.polar(raw, i, box, forces.mark, false) : cells.near(raw, i, box, forces.mark, false);
  }

  /** Sorts the boxes after a step into the charts of the asteroids that may be nearest. */
  private sortIn(next: Layer): string | null {
    const { cells, charts, raw, box } = this;
    const { range } = this.setting.level;
    const count = charts.rocks.length;
    for (let b = 0; b < raw.size; b++) {
      let why = this.whyTooMuch();
      if (why !== null) return why;
      for (let n = 0, o = b * NUMBERS; n < NUMBERS; n++, o++) box[n] = raw.boxes[o];
      const chart = raw.charts[b];
      const i = chart >> 1;
      const isPolar = chart % 2 === 0;
      for (let j = 0; j < count; j++) {
        if (j === i) continue;
        charts.rectOf(box, isPolar);
        if ((raw.marks[b] & (1 << (j & 31))) === 0 || !charts.mayBeNearer(i, j)) continue;
        why = isPolar ? this.convertParts(box, i, j, next) : this.convert(box, chart, j, next);
        if (why !== null) return why;
      }
      charts.rectOf(box, isPolar);
      const near = isPolar ? box[0] : charts.rect.nearest();
      if (near > range + SLACK) {
        this.endedBy.add(RANGE);
        continue;
      }
      if (count > 1 && !charts.mayBeNearest(i)) continue;
      const border = charts.border(box[8], box[9]);
      if (isPolar ? box[1] <= border : near >= border) why = this.convert(box, chart, i, next);
      else why = isPolar ? cells.polar(next, i, box, 0, true) : cells.near(next, i, box, 0, true);
      if (why !== null) return why;
    }
    return null;
  }

  /** Puts the parts of a box in polar coordinates from which another asteroid may be nearer into the charts of that one. */
  private convertParts(box: Float64Array, i: number, j: number, next: Layer): string | null {
    const { charts, cut } = this;
    for (let n = 0; n < 8; n++) {
      cut.set(box);
      for (let k = 0; k < 3; k++) {
        const at = 2 * k;
        const middle = (box[at] + box[at + 1]) / 2;
        cut[at + 1 - ((n >> k) & 1)] = middle;
      }
      if (!agree(cut)) continue;
      charts.rectOf(cut, true);
      const why = charts.mayBeNearer(i, j) ? this.convert(cut, 2 * i, j, next) : null;
      if (why !== null) return why;
    }
    return null;
  }

  /** Puts a box of a chart into the charts of asteroid j. */
  private convert(box: Float64Array, chart: number, j: number, layer: Layer): string | null {
    const { cells, charts } = this;
    const polar = charts.fill(box, chart, j, false);
    if (polar === null) return null;
    return polar ? cells.polar(layer, j, charts.made, 0, true) : cells.near(layer, j, charts.made, 0, true);
  }
}

import { type Box, TICK } from '../../engine/index.ts';
import type { Disc, Place } from '../../schema/basics/index.ts';
import { bendWithin, driftAfter, recoilBlur } from './assumptions.ts';
import { type ChaserDisc, chase, joinedChasers } from './chaser.ts';
import type { About, Blocker, Flowpipe, PipeGrid, PipePart, PipeStep, Strip, ThingRef } from './proof.ts';
import { RIM_SLACK, rimDiscs, type Setting, type Spot, type Thing } from './setting.ts';

/** The directions in which sets of places are bounded, in eighths of a turn. Direction m + 4 is opposite to direction m. */
const DIAGONAL = Math.sqrt(0.5);
export const DIRECTIONS: readonly (readonly [number, number])[] = [
  [1, 0],
  [DIAGONAL, DIAGONAL],
  [0, 1],
  [-DIAGONAL, DIAGONAL],
  [-1, 0],
  [-DIAGONAL, -DIAGONAL],
  [0, -1],
  [DIAGONAL, -DIAGONAL],
];
const SIDES = DIRECTIONS.length;
const opposite = (m: number): number => (m + SIDES / 2) % SIDES;

/** Every bound is rounded outwards by this, px. */
const SLACK = 1e-6;

/**
 * A hazard counts from this depth on, px, because the checker computes the discs of aliens and the directions of her box by
 * itself, and its last digits differ.
 */
const DEEP = 1e-5;

/** Strips begin at whole millionths of a px, which are short to write down. */
const PARTS = 1e6;

/** A set is cut where it is wider than this many cells. */
const WIDE = 1.6;

/** Bisections that find how much of a set a hazard takes off, and the least width that is worth a strip, px. */
const BISECTIONS = 8;
const WORTH = 0.001;

/** Possible angles of her box: a direction of its x axis, and the largest deviation from it as a chord; 2 allows any angle. */
interface Turn {
  readonly x: number;
  readonly y: number;
  readonly chord: number;
}

const ANY_TURN: Turn = { x: 1, y: 0, chord: 2 };

/**
 * A set of states, described by drift places: for each moment of the grid, an octagon of the places where she would be then if
 * she drifted from now on. It includes her place, her velocity and how the two depend on each other, and while she drifts
 * nothing of it changes.
 */
export interface Pipe {
  /** Greatest coordinate in each direction, px; index moment * 8 + direction. */
  readonly far: Float64Array;
  readonly turn: Turn;
  readonly aliens: readonly ChaserDisc[];
}

/** Least and greatest x and y, px. */
type Rectangle = readonly [number, number, number, number];

/** Everything that she may do from the start, as far as it was followed. */
export interface PipeResult {
  /** Every run has ended, and none came near the object. */
  readonly closed: boolean;
  /** There were too many sets or parts, or one came near the object, so that a longer horizon would not help. */
  readonly hopeless: boolean;
  /** What happens to each set, for all complete steps. */
  readonly layers: Flowpipe['layers'];
  /** What ended runs. */
  readonly endedBy: readonly Blocker[];
  /** The squares through which she may come: their lower left corners along the grid's axes, px. */
  readonly squares: readonly Place[];
}

/**
 * Computes a flowpipe of everything that she may do: sets of states, described by drift places at each of several moments. A
 * push a(s) shifts the drift place of moment t by the integral of (t - s) a(s). After each step, strips that certainly overlap
 * a hazard are cut off; the angle of her box is known well enough for that, because it points at the target since the last
 * press. Sets are cut along a grid over the drift places of two moments, and joined in its cells.
 * @param watch called with the sets at the start of each step, which is numbered from 0
 */
export function followPipes(
  setting: Setting,
  about: About,
  goal: Thing,
  grid: PipeGrid,
  most: { readonly sets: number; readonly parts: number },
  watch?: (pipes: readonly Pipe[], step: number) => void,
): PipeResult {
  const reach = new PipeReach(setting, about, goal, grid);
  const layers: (readonly [PipeStep, PipeStep])[][] = [];
  let pipes = [reach.start()];
  let sets = 0;
  let parts = 0;
  watch?.(pipes, 0);
  while (layers.length < grid.steps) {
    const next: Layer = { pipes: [], inCells: new Map() };
    const taken: (readonly [PipeStep, PipeStep])[] = [];
    for (const pipe of pipes) {
      const steps = reach.advance(pipe, layers.length + 1, next);
      if (steps === null) return reach.result(false, true, layers);
      parts += steps[0].parts.length + steps[1].parts.length;
      if (sets + next.pipes.length > most.sets || parts > most.parts) return reach.result(false, true, layers);
      taken.push(steps);
    }
    layers.push(taken);
    pipes = next.pipes;
    watch?.(pipes, layers.length);
    sets += pipes.length;
    if (pipes.length === 0) return reach.result(true, false, layers);
  }
  return reach.result(false, false, layers);
}

/** The sets after a step, and which of them lies in which cell. */
interface Layer {
  readonly pipes: Pipe[];
  readonly inCells: Map<number, number>;
}

class PipeReach {
  private readonly setting: Setting;
  private readonly grid: PipeGrid;
  /** Length of a step, s. */
  private readonly step: number;
  /** The two moments whose drift places the grid cuts. */
  private readonly early: number;
  private readonly late: number;
  private readonly goal: Spot;
  private readonly rocks: readonly Spot[];
  private readonly fields: readonly Spot[];
  private readonly rims: readonly Spot[];
  private readonly still: readonly (Spot & { readonly of: ThingRef; readonly asteroid: number })[];
  private readonly endedBy = new Set<string>();
  private readonly enders: Blocker[] = [];
  private readonly squares = new Map<number, Place>();
  private readonly blur: number;
  private readonly pulls = new Float64Array(SIDES);
  private readonly pushes = new Float64Array(SIDES);

  constructor(setting: Setting, about: About, goal: Thing, grid: PipeGrid) {
    const { level } = setting;
    const { astronaut } = level;
    this.setting = setting;
    this.grid = grid;
    this.step = grid.frames * TICK;
    this.blur = recoilBlur(setting);
    this.late = grid.steps;
    this.early = Math.floor(grid.steps / 3);
    const circle = (c: Disc): Spot => ({
      ...this.turned({ x: c.x - astronaut.x, y: c.y - astronaut.y }),
      r: c.radius,
    });
    this.goal = { ...this.turned(goal), r: goal.touch };
    this.rocks = level.asteroids.map(circle);
    this.fields = level.repulsors.map(circle);
    this.rims = rimDiscs(level).map(circle);
    this.still = [
      ...level.novae.map((c, index) => ({ ...circle(c), of: { kind: 'nova' as const, index }, asteroid: -1 })),
      ...level.asteroids.flatMap((c, index) =>
        c.hot ? [{ ...circle(c), of: { kind: 'asteroid' as const, index }, asteroid: index }] : [],
      ),
      ...(about.kind === 'mineral'
        ? [{ ...circle(level.blackHole), of: { kind: 'blackHole' as const, index: 0 }, asteroid: -1 }]
        : []),
    ];
  }

  private turned({ x, y }: Place): Place {
    const [ux, uy] = this.grid.axis;
    return { x: x * ux + y * uy, y: y * ux - x * uy };
  }

  result(closed: boolean, hopeless: boolean, layers: Flowpipe['layers']): PipeResult {
    return { closed, hopeless, layers, endedBy: this.enders, squares: [...this.squares.values()] };
  }

  start(): Pipe {
    const { astronaut, aliens } = this.setting.level;
    const v = this.turned({ x: astronaut.vx, y: astronaut.vy });
    const far = new Float64Array((this.grid.steps + 1) * SIDES);
    for (let moment = 0; moment <= this.grid.steps; moment++) {
      for (const [m, [x, y]] of DIRECTIONS.entries()) far[moment * SIDES + m] = (v.x * x + v.y * y) * moment * this.step + SLACK;
    }
    return {
      far,
      turn: { ...this.turned({ x: 1, y: 0 }), chord: SLACK },
      aliens: aliens.map((a) => ({
        ...this.turned({ x: a.x - astronaut.x, y: a.y - astronaut.y }),
        r: SLACK,
        vx: 0,
        vy: 0,
        vr: 0,
        touch: a.radius,
        doubtful: false,
      })),
    };
  }

  private drift(i: number, seconds: number): number {
    return driftAfter(this.setting, i, seconds);
  }

  /**
   * Adds what a set becomes until the moment `to`, with and without a press, to `next`. Returns null when it comes near the
   * object.
   */
  advance({ far, turn, aliens }: Pipe, to: number, next: Layer): readonly [PipeStep, PipeStep] | null {
    const { step } = this;
    const things = this.still.length + 2 * this.rocks.length + this.fields.length + aliens.length;
    this.setting.budget.look(8 * this.grid.steps + things);
    const way = this.placesUntil(far, to);
    if (nearestTo(this.goal, way) <= this.goal.r + SLACK) return null;
    if (this.rims.some((rim) => nearestTo(rim, way) <= rim.r + RIM_SLACK)) return null;
    const isPushed = this.pushesWithin(way);
    const aimed = this.pullsWithin(way, to * step);
    const pressed = far.slice();
    const free = isPushed === false ? far : far.slice();
    for (let moment = 0; moment <= this.grid.steps; moment++) {
      if (moment < to && moment !== this.early) continue;
      // The remaining time to the moment, integrated over the step: how far a push of 1 px/s² shifts its drift place.
      const lever = step * (moment - to) * step + 0.5 * step * step;
      for (let m = 0; m < SIDES; m++) {
        const along = lever > 0 ? m : opposite(m);
        const push = isPushed === 'always' ? this.pushes[along] : Math.max(0, isPushed ? this.pushes[along] : 0);
        const force = isPushed === 'always' ? push : Math.max(push, this.pulls[along]);
        pressed[moment * SIDES + m] += Math.abs(lever) * (force + this.blur) + SLACK;
        if (isPushed) free[moment * SIDES + m] += Math.abs(lever) * push + SLACK;
      }
    }
    const { alienPull, alienSight } = this.setting.rules;
    const chasing = chase(aliens, way, step, alienPull, alienSight);
    return [
      this.put(next, { far: pressed, turn: aimed, aliens: chasing }, to),
      this.put(next, { far: free, turn, aliens: chasing }, to),
    ];
  }

  /** All places up to a moment: the drift, and how far any push can bend it. */
  private placesUntil(far: Float64Array, to: number): Rectangle {
    const now = (to - 1) * SIDES;
    const then = to * SIDES;
    // A stage of a stepping method may also lie beside the path.
    const strongest = this.setting.strongest + this.blur;
    const bend = bendWithin(strongest, this.step * this.step) + Math.max(0.01, 2.5e-4 * strongest);
    const most = (m: number) => Math.max(far[now + m], far[then + m]) + bend;
    return [-most(4), most(0), -most(6), most(2)];
  }

  /** Writes the greatest acceleration by the gun in each direction, and returns how it may turn her box. */
  private pullsWithin(way: Rectangle, seconds: number): Turn {
    const { rocks, pulls } = this;
    const { pull } = this.setting.rules;
    const { range, recoil } = this.setting.level;
    const middle = { x: (way[0] + way[1]) / 2, y: (way[2] + way[3]) / 2 };
    const around = length(way[1] - way[0], way[3] - way[2]) / 2;
    let nearest = 0;
    let reach = Number.POSITIVE_INFINITY;
    for (const [i, rock] of rocks.entries()) {
      reach = Math.min(reach, farthestFrom(rock, way) + this.drift(i, seconds));
      if (length(rock.x - middle.x, rock.y - middle.y) < length(rocks[nearest].x - middle.x, rocks[nearest].y - middle.y))
        nearest = i;
    }
    pulls.fill(0);
    let turn: Turn | null = null;
    for (const [i, rock] of rocks.entries()) {
      const moved = this.drift(i, seconds);
      const near = nearestTo(rock, way) - moved;
      if (near > reach + SLACK || (!recoil && i !== nearest && isFartherAll(rock, rocks[nearest], way))) continue;
      const dx = rock.x - middle.x;
      const dy = rock.y - middle.y;
      const d = length(dx, dy);
      const blur = around + moved + SLACK;
      if (d - blur < 4) {
        pulls.fill(pull);
        turn = ANY_TURN;
        continue;
      }
      // The pull is `strength` times the vector to the asteroid; it changes by no more than `steepest` per px.
      const strength = (at: number) => Math.max(0, pull * (1 / at - 1 / range));
      const steepest = pull * Math.max(1 / (d - blur), 1 / range);
      const weak = strength(farthestFrom(rock, way) + moved);
      const strong = strength(near);
      for (const [m, [x, y]] of DIRECTIONS.entries()) {
        const about = strength(d) * (x * dx + y * dy) + steepest * blur;
        const ahead =
          Math.max(x * (rock.x - way[0]), x * (rock.x - way[1])) + Math.max(y * (rock.y - way[2]), y * (rock.y - way[3])) + moved;
        pulls[m] = Math.max(pulls[m], Math.min(about, ahead * (ahead > 0 ? strong : weak)) + SLACK);
      }
      const aimed = turnTo(dx, dy, d, blur);
      turn = turn === null ? aimed : joinedTurn(turn, aimed);
    }
    return turn ?? ANY_TURN;
  }

  /** Writes the greatest acceleration by fields in each direction, and returns whether she may be, or certainly is, in one. */
  private pushesWithin(way: Rectangle): 'always' | boolean {
    const { pushes } = this;
    const { push } = this.setting.rules;
    pushes.fill(Number.NEGATIVE_INFINITY);
    let result: 'always' | boolean = false;
    const middle = { x: (way[0] + way[1]) / 2, y: (way[2] + way[3]) / 2 };
    const around = length(way[1] - way[0], way[3] - way[2]) / 2 + SLACK;
    for (const field of this.fields) {
      if (nearestTo(field, way) > field.r + SLACK) continue;
      if (farthestFrom(field, way) < field.r - SLACK) result = 'always';
      else if (result === false) result = true;
      const dx = middle.x - field.x;
      const dy = middle.y - field.y;
      const d = length(dx, dy);
      for (const [m, [x, y]] of DIRECTIONS.entries()) {
        const about = d - around < 2 ? push : (push * (x * dx + y * dy)) / d + (push / (d - around)) * around;
        pushes[m] = Math.max(pushes[m], Math.min(push, about) + SLACK);
      }
    }
    return result;
  }

  /**
   * Cuts a set along the grid, and adds the parts that have not ended to the layer, joined with what is there. Returns what it
   * did.
   */
  private put(layer: Layer, pipe: Pipe, moment: number): PipeStep {
    const { far, turn } = pipe;
    const { cell } = this.grid;
    const early = this.early * SIDES;
    const late = this.late * SIDES;
    const cuts = [early, early + 2, late, late + 2].map((at) => cutsOf(-far[at + 4], far[at], cell));
    const [cx, cy, dx, dy] = cuts;
    const turned = classOf(turn, this.grid.turns);
    const parts: PipePart[] = [];
    for (let i = cx.first; i <= cx.last; i++) {
      for (let j = cy.first; j <= cy.last; j++) {
        for (let k = dx.first; k <= dx.last; k++) {
          for (let l = dy.first; l <= dy.last; l++) {
            const part = this.partOf(far, moment, [
              [cx, i],
              [cy, j],
              [dx, k],
              [dy, l],
            ]);
            const off: Strip[] = [];
            if (part === null || this.isOver(part, pipe, moment, off)) {
              parts.push({ off, to: null });
              continue;
            }
            this.visit(part, moment);
            const key = ((((i + 2048) * 4096 + (j + 2048)) * 4096 + (k + 2048)) * 4096 + (l + 2048)) * 8 + turned;
            const to = layer.inCells.get(key) ?? layer.pipes.length;
            const there = layer.pipes[to];
            layer.inCells.set(key, to);
            layer.pipes[to] = there === undefined ? { ...pipe, far: part } : joined(there, { ...pipe, far: part });
            parts.push({ off, to });
          }
        }
      }
    }
    return { cuts: cuts.map(({ first, last }) => Array.from({ length: last - first }, (_, n) => (first + n + 1) * cell)), parts };
  }

  /** The part of a set that lies in a cell; null when it is empty. */
  private partOf(far: Float64Array, moment: number, cell: readonly (readonly [Cuts, number])[]): Float64Array | null {
    const part = far.slice();
    if (cell.every(([{ first, last }]) => first === last)) return part;
    const sides = [this.early, this.late].map((at, n) => {
      const most = (m: number, [{ first, last }, index]: readonly [Cuts, number], sign: number): number => {
        const own = far[at * SIDES + m];
        if (first === last) return own;
        return Math.min(own, sign > 0 ? (index + 1) * this.grid.cell : -index * this.grid.cell);
      };
      const right = most(0, cell[2 * n], 1);
      const up = most(2, cell[2 * n + 1], 1);
      const left = most(4, cell[2 * n], -1);
      const down = most(6, cell[2 * n + 1], -1);
      return [right, right + up, up, up + left, left, left + down, down, down + right].map((far, m) =>
        m % 2 === 0 ? far : far * DIAGONAL,
      );
    });
    for (let at = 0; at <= this.grid.steps; at++) {
      if (at < moment && at !== this.early) continue;
      // A drift is a straight line: its place at one moment follows from the places at the two moments of the grid.
      const share = (this.late - at) / (this.late - this.early);
      for (let m = 0; m < SIDES; m++) {
        const first = share >= 0 ? share * sides[0][m] : -share * sides[0][opposite(m)];
        const second = share <= 1 ? (1 - share) * sides[1][m] : (share - 1) * sides[1][opposite(m)];
        part[at * SIDES + m] = Math.min(part[at * SIDES + m], first + second + SLACK);
      }
      for (let m = 0; m < SIDES / 2; m++) if (part[at * SIDES + m] + part[at * SIDES + opposite(m)] < -SLACK) return null;
    }
    return part;
  }

  /**
   * Takes off a set what certainly overlaps a hazard at a moment, and adds the strips to `off`. Returns true when nothing is
   * left, or all of it is out of range.
   */
  private isOver(far: Float64Array, { turn, aliens }: Pipe, moment: number, off: Strip[]): boolean {
    const seconds = moment * this.step;
    const { box } = this.setting;
    this.setting.budget.look(4 * this.still.length + 4 * aliens.length + this.rocks.length);
    const over = (of: Blocker): true => {
      const name = of.kind === 'range' ? of.kind : `${of.kind} ${of.index}`;
      if (!this.endedBy.has(name)) this.enders.push(of);
      this.endedBy.add(name);
      return true;
    };
    for (const hazard of this.still) {
      const r = hazard.r - (hazard.asteroid < 0 ? 0 : this.drift(hazard.asteroid, seconds));
      if (r > 0 && takeOff(box, far, moment, { ...hazard, r: r - DEEP }, hazard.of, turn, off)) return over(hazard.of);
    }
    for (const [index, alien] of aliens.entries()) {
      const of: ThingRef = { kind: 'alien', index };
      if (!alien.doubtful && takeOff(box, far, moment, { ...alien, r: alien.touch - alien.r - DEEP }, of, turn, off))
        return over(of);
    }
    const now = moment * SIDES;
    const here: Rectangle = [-far[now + 4], far[now], -far[now + 6], far[now + 2]];
    const { range } = this.setting.level;
    const lost = this.rocks.every((rock, i) => nearestTo(rock, here) > range + this.drift(i, seconds) + SLACK);
    return lost && over({ kind: 'range' });
  }

  private visit(far: Float64Array, moment: number): void {
    const { cell } = this.grid;
    const now = moment * SIDES;
    for (let i = Math.floor(-far[now + 4] / cell); i * cell <= far[now]; i++) {
      for (let j = Math.floor(-far[now + 6] / cell); j * cell <= far[now + 2]; j++) {
        this.squares.set(i * 32768 + j, { x: i * cell, y: j * cell });
      }
    }
  }
}

/** Cells from the first to the last; a single cell means that nothing is cut. */
interface Cuts {
  readonly first: number;
  readonly last: number;
}

function cutsOf(from: number, to: number, cell: number): Cuts {
  const middle = Math.floor((from + to) / 2 / cell);
  return to - from <= WIDE * cell
    ? { first: middle, last: middle }
    : { first: Math.floor(from / cell), last: Math.floor(to / cell) };
}

/**
 * Takes off what lies in a hazard, from one side, by the circle in her box and by the box at its possible angles. Returns true
 * when nothing is left.
 */
function takeOff(
  { halfWidth, halfHeight, halfDiagonal }: Box,
  far: Float64Array,
  moment: number,
  hazard: Spot,
  by: ThingRef,
  turn: Turn,
  off: Strip[],
): boolean {
  const now = moment * SIDES;
  const { r } = hazard;
  const reach = r + halfDiagonal;
  if (hazard.x > far[now] + reach || hazard.x < -far[now + 4] - reach) return false;
  if (hazard.y > far[now + 2] + reach || hazard.y < -far[now + 6] - reach) return false;
  // Both zones are convex: a set whose corners lie in one lies in it entirely.
  const rr = r - halfDiagonal * turn.chord;
  const zones = [
    (x: number, y: number) => length(hazard.x - x, hazard.y - y) < r + Math.min(halfWidth, halfHeight),
    (x: number, y: number) => {
      const dx = hazard.x - x;
      const dy = hazard.y - y;
      const along = Math.max(0, Math.abs(dx * turn.x + dy * turn.y) - halfWidth);
      const across = Math.max(0, Math.abs(dy * turn.x - dx * turn.y) - halfHeight);
      return length(along, across) < rr;
    },
  ];
  for (const zone of rr > 0 ? zones : zones.slice(0, 1)) {
    for (const first of [0, 1]) {
      const strip = takeOffAlong(far, now, first, zone);
      if (strip === null) continue;
      off.push({ by, ...strip });
      if (strip.at <= -far[now + opposite(strip.side)]) return true;
    }
  }
  return false;
}

/**
 * The same for the rectangle that contains the set, with its sides along a direction and across. Returns what is taken off,
 * possibly all of it.
 */
function takeOffAlong(
  far: Float64Array,
  now: number,
  first: number,
  zone: (x: number, y: number) => boolean,
): Omit<Strip, 'by'> | null {
  const [ax, ay] = DIRECTIONS[first];
  const at = (s: number, q: number) => zone(s * ax - q * ay, s * ay + q * ax);
  const [right, up, left, down] = [now + first, now + first + 2, now + first + 4, now + first + 6];
  const corner = [at(far[right], far[up]), at(-far[left], far[up]), at(-far[left], -far[down]), at(far[right], -far[down])];
  if (corner.every(Boolean)) return { side: first, at: Math.floor(-far[left] * PARTS) / PARTS };
  const take = (side: number, across: number, isIn: (distance: number) => boolean) => {
    let inside = far[side];
    let outside = -far[across];
    for (let n = 0; n < BISECTIONS; n++) {
      const middle = (inside + outside) / 2;
      if (isIn(middle)) inside = middle;
      else outside = middle;
    }
    const begins = Math.ceil(inside * PARTS) / PARTS;
    if (far[side] - begins <= WORTH) return null;
    far[side] = begins + SLACK;
    return { side: side - now, at: begins };
  };
  if (corner[3] && corner[0]) return take(right, left, (s) => at(s, far[up]) && at(s, -far[down]));
  if (corner[0] && corner[1]) return take(up, down, (q) => at(far[right], q) && at(-far[left], q));
  if (corner[1] && corner[2]) return take(left, right, (s) => at(-s, far[up]) && at(-s, -far[down]));
  if (corner[2] && corner[3]) return take(down, up, (q) => at(far[right], -q) && at(-far[left], -q));
  return null;
}

/** A set that contains two others. */
function joined(a: Pipe, b: Pipe): Pipe {
  const { far } = a;
  for (let i = 0; i < far.length; i++) if (b.far[i] > far[i]) far[i] = b.far[i];
  return { far, turn: joinedTurn(a.turn, b.turn), aliens: joinedChasers(a.aliens, b.aliens) };
}

/**
 * Turned towards a place whose distance is known up to `blur`: an arc asin(c) has a chord of at most 1.04 c, for c up to 1/2.
 */
function turnTo(dx: number, dy: number, d: number, blur: number): Turn {
  return blur > d / 2 ? ANY_TURN : { x: dx / d, y: dy / d, chord: (1.1 * blur) / d };
}

/** Half a turn does not change the box. */
function joinedTurn(a: Turn, b: Turn): Turn {
  const sign = a.x * b.x + a.y * b.y < 0 ? -1 : 1;
  const x = a.x + sign * b.x;
  const y = a.y + sign * b.y;
  const l = length(x, y);
  const off = (t: Turn, s: number) => length(x / l - s * t.x, y / l - s * t.y) + t.chord + SLACK * SLACK;
  return { x: x / l, y: y / l, chord: Math.min(2, Math.max(off(a, 1), off(b, sign))) };
}

/** The part of half a turn, of `parts`, in which a direction lies. */
function classOf({ x, y }: Turn, parts: number): number {
  const up = y < 0 || (y === 0 && x < 0) ? -1 : 1;
  const share = x * up >= 0 ? (y * up) / (x * up + y * up) : 1 - (x * up) / (y * up - x * up);
  return Math.min(parts - 1, Math.floor((share / 2) * parts));
}

/** Whether all of a rectangle is nearer to another asteroid than to this one. */
function isFartherAll(rock: Spot, other: Spot, [xa, xb, ya, yb]: Rectangle): boolean {
  const dx = other.x - rock.x;
  const dy = other.y - rock.y;
  const x = dx > 0 ? xa : xb;
  const y = dy > 0 ? ya : yb;
  return (x - (rock.x + other.x) / 2) * dx + (y - (rock.y + other.y) / 2) * dy > SLACK * length(dx, dy);
}

const length = (x: number, y: number): number => Math.sqrt(x * x + y * y);

const nearestTo = ({ x, y }: Place, [xa, xb, ya, yb]: Rectangle): number =>
  length(Math.max(0, xa - x, x - xb), Math.max(0, ya - y, y - yb));

const farthestFrom = ({ x, y }: Place, [xa, xb, ya, yb]: Rectangle): number =>
  length(Math.max(x - xa, xb - x), Math.max(y - ya, yb - y));

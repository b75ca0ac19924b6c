import { type Box, boxCircleGap } from '../../engine/index.ts';
import type { Disc, Place } from '../../schema/basics/index.ts';
import { speedAfter, unbentSpeed } from './assumptions.ts';
import type { StandingCircle } from './blockers.ts';
import { between, convexHull, type Vertex } from './convex.ts';
import type { DeadEnd, Direction } from './proof.ts';
import { distance, margin, surelyLess } from './rounding.ts';
import { rimDiscs, type Setting, type Thing } from './setting.ts';

/** Distance between two lines across the axis, px. */
const STEP = 1;

/** Length of the pieces of such a line that are tested against hazards, px. */
const PIECE = 1;

/** How far beside the line she may be when she leaves it, px, and the error of her slope. Rounding is far below both. */
const BESIDE = 0.01;
const ASKEW = 1e-6;

/** A hazard counts from this depth on, px, because an integrator may use the push of a place just inside. */
const DEEP = 0.05;

/** Bounds on slopes, and on places where another asteroid is nearer, are rounded outwards by this. */
const SLACK = 1e-6;

/** Two distances that differ by less count as equal, px. */
const TIE = 1e-7;

/** Steeper paths are not followed, nor pushes from closer than this, px. */
const STEEPEST = 6;
const NEAREST = 0.5;

/** The most fronts, and the most comparisons of asteroids. */
const MOST_FRONTS = 1500;
const MOST_COMPARISONS = 400_000;

/** Ranges of directions of her box with a smaller chord are not divided any further. */
const FINEST_TURN = 0.002;

/** Least and greatest. */
type Span = readonly [least: number, most: number];

/** A possible push: its centre, whether it points towards the centre, and where it acts along a line across. */
interface Push {
  readonly centre: Place;
  readonly towards: boolean;
  readonly from: number;
  readonly to: number;
}

/**
 * The set of states in which she may cross a line: a convex polygon in place across (`x` of a vertex, px) and slope of her path
 * (`y`: px across per px along), and the slopes of the x axis of her box.
 */
interface Front {
  readonly ways: readonly Vertex[];
  readonly box: Span;
}

/**
 * Tries to prove that everything she may do beyond a border, where another asteroid becomes the nearest, ends at hazards.
 *
 * The invariant: along some axis every push beyond the border points forward, and so does her motion. Her velocity is a sum of
 * the earlier one and of pushes, all with positive weights, so the slope of her path only ever turns towards the slopes of the
 * pushes, whatever her speed and whenever she presses (lemma `slopes`). It follows that a convex set of places and slopes,
 * propagated from line to line across the axis, contains everything that she may do. Hazards and the end of the range cut parts
 * off the set; the end is dead when nothing is left. The previous asteroid must never become the nearest again (lemma
 * `leaving`), and no part may come near the object. With recoil the border would move, and with frames she could jump over it,
 * so neither is covered.
 * @param apex where she leaves the line, px from the start
 * @param ahead her direction there, a unit vector
 * @param before the asteroid that pulled her before
 */
export function findDeadEnd(
  setting: Setting,
  goal: Thing,
  circles: readonly StandingCircle[],
  apex: Place,
  ahead: Place,
  before: number,
): DeadEnd | null {
  // In frames she may jump over the border between two asteroids, and recoil would move it.
  if (setting.level.recoil || setting.jump > 0) return null;
  const takers = takersAt(setting, apex, before);
  if (takers.length === 0) return null;
  const { asteroids, astronaut } = setting.level;
  const { x, y } = asteroids[takers[0]];
  const way = { x: x - astronaut.x - apex.x, y: y - astronaut.y - apex.y };
  const far = Math.sqrt(way.x * way.x + way.y * way.y);
  if (far < NEAREST) return null;
  const pulled = { x: way.x / far, y: way.y / far };
  for (const part of [0.5, 0, 1]) {
    const axis = unit({ x: ahead.x + part * (pulled.x - ahead.x), y: ahead.y + part * (pulled.y - ahead.y) });
    if (axis !== null && new Propagation(setting, goal, circles, apex, ahead, before, takers, axis).isShut())
      return { axis, step: STEP };
  }
  return null;
}

function unit({ x, y }: Place): Direction | null {
  const length = Math.sqrt(x * x + y * y);
  return length < 0.1 ? null : [x / length, y / length];
}

/** Where she may come in a dead end: corners of quadrilaterals, px from the start. */
export function placesIn(
  setting: Setting,
  goal: Thing,
  circles: readonly StandingCircle[],
  apex: Place,
  ahead: Place,
  before: number,
  { axis }: DeadEnd,
): Place[][] {
  const propagation = new Propagation(setting, goal, circles, apex, ahead, before, takersAt(setting, apex, before), axis);
  propagation.isShut();
  const [ux, uy] = axis;
  return propagation.pieces.map(({ line, before: [from, to], after: [low, high] }) =>
    [
      [line, from],
      [line + STEP, low],
      [line + STEP, high],
      [line, to],
    ].map(([a, b]) => ({ x: apex.x + a * ux - b * uy, y: apex.y + a * uy + b * ux })),
  );
}

/** The asteroids that are as near at the apex as the previous one. */
function takersAt({ level: { asteroids, astronaut } }: Setting, apex: Place, before: number): number[] {
  const here = { x: apex.x + astronaut.x, y: apex.y + astronaut.y };
  const old = distance(asteroids[before], here);
  return [...asteroids.keys()].filter((i) => i !== before && distance(asteroids[i], here) < old + TIE);
}

/** Propagates everything that she may do beyond the apex. Places are px from the apex, along the axis and across. */
class Propagation {
  private readonly range: number;
  private readonly strongest: number;
  private readonly unbent: number;
  private readonly box: Box;
  private readonly leastHalf: number;
  private readonly goal: Place & { readonly touch: number };
  private readonly circles: readonly StandingCircle[];
  private readonly asteroids: readonly Place[];
  private readonly before: number;
  private readonly takers: readonly number[];
  private readonly fields: readonly Disc[];
  private readonly rims: readonly Disc[];
  private readonly ahead: Place;
  private comparisons = 0;
  /** All slopes of her path so far. */
  private slopes: Span;
  /** Where she may come between a line and the next: the spans across on both. */
  readonly pieces: { readonly line: number; readonly before: Span; readonly after: Span }[] = [];

  constructor(
    { level, rules, strongest, box, leastHalf }: Setting,
    goal: Thing,
    circles: readonly StandingCircle[],
    apex: Place,
    ahead: Place,
    before: number,
    takers: readonly number[],
    [ux, uy]: Direction,
  ) {
    const turned = <T extends Place>(p: T): T => ({ ...p, x: p.x * ux + p.y * uy, y: p.y * ux - p.x * uy });
    const fromApex = <T extends Place>(p: T): T => turned({ ...p, x: p.x - apex.x, y: p.y - apex.y });
    const fromStart = <T extends Place>(p: T): T => fromApex({ ...p, x: p.x - level.astronaut.x, y: p.y - level.astronaut.y });
    this.range = level.range;
    this.strongest = strongest;
    this.unbent = unbentSpeed(rules, strongest);
    this.box = box;
    this.leastHalf = leastHalf;
    this.goal = fromApex(goal);
    this.circles = circles.map(fromApex);
    this.asteroids = level.asteroids.map(fromStart);
    this.fields = level.repulsors.map(fromStart);
    this.rims = rimDiscs(level).map(fromStart);
    this.before = before;
    this.takers = takers;
    this.ahead = turned(ahead);
    this.slopes = [this.ahead.y / this.ahead.x, this.ahead.y / this.ahead.x];
  }

  /** Whether all of it ends, and none of it comes near the object or back into the previous asteroid's cell. */
  isShut(): boolean {
    if (this.ahead.x * STEEPEST < Math.abs(this.ahead.y)) return false;
    const [slope] = this.slopes;
    const ways = [-BESIDE, BESIDE].flatMap((x) => [-ASKEW, ASKEW].map((more) => ({ x, y: slope + more })));
    let fronts: Front[] = [{ ways: convexHull(ways), box: [slope - ASKEW, slope + ASKEW] }];
    let made = 0;
    for (let step = 0; fronts.length > 0; step++) {
      const next: Front[] = [];
      for (const front of fronts) {
        const after = this.advance(front, step * STEP);
        made++;
        if (after === null || made > MOST_FRONTS || this.comparisons > MOST_COMPARISONS) return false;
        next.push(...this.notOver(after, (step + 1) * STEP));
      }
      fronts = next;
    }
    return !this.isTooLong() && this.takers.some((i) => this.leavesBehind(i));
  }

  /** Whether she may become so fast, over all of this and the line before, that the speed limit bends her path. */
  private isTooLong(): boolean {
    let far = 0;
    for (const { line, before, after } of this.pieces) {
      far = Math.max(far, line + 9 * STEP + Math.max(...[...before, ...after].map(Math.abs)));
    }
    return speedAfter(this.strongest, 2 * this.range + 2 * far) > this.unbent;
  }

  /** Whether, with every slope that occurs, she comes nearer to an asteroid faster than to the previous one. */
  private leavesBehind(taker: number): boolean {
    const { x, y } = this.asteroids[taker];
    const old = this.asteroids[this.before];
    return this.slopes.every((slope) => x - old.x + slope * (y - old.y) > SLACK);
  }

  /** Propagates a front by one step; null when this is not possible or the front comes near the object. */
  private advance({ ways, box }: Front, line: number): Front | null {
    const places = spanOf(ways.map(({ x }) => x));
    const slopes = spanOf(ways.map(({ y }) => y));
    let aside = STEP * Math.max(Math.abs(slopes[0]), Math.abs(slopes[1])) + SLACK;
    for (let steepest = aside / STEP; ; aside = 1.01 * STEP * steepest) {
      if (steepest > STEEPEST) return null;
      const pushes = this.pushes(line, [places[0] - aside, places[1] + aside]);
      if (pushes === null) return null;
      const after = pushed(ways, places, line, aside, pushes);
      steepest = Math.max(Math.abs(after.slopes[0]), Math.abs(after.slopes[1]));
      if (STEP * steepest > aside) continue;
      this.slopes = join(this.slopes, after.slopes);
      this.pieces.push({ line, before: places, after: spanOf(after.ways.map(({ x }) => x)) });
      const dx = Math.max(0, line - this.goal.x, this.goal.x - line - STEP);
      const dy = Math.max(0, places[0] - aside - this.goal.y, this.goal.y - places[1] - aside);
      if (!surelyLess(this.goal.touch + DEEP, Math.sqrt(dx * dx + dy * dy))) return null;
      return { ways: after.ways, box: after.pulls === null ? box : join(box, after.pulls) };
    }
  }

  /**
   * Everything that may push her between two lines, within `places` across; null when some of it may push her back, or when the
   * number of comparisons is exceeded.
   */
  private pushes(line: number, places: Span): Push[] | null {
    const end = line + STEP;
    const pushes: Push[] = [];
    for (const rim of this.rims) {
      const dx = Math.max(0, line - rim.x, rim.x - end);
      const dy = Math.max(0, places[0] - rim.y, rim.y - places[1]);
      if (!surelyLess(rim.radius + DEEP, Math.sqrt(dx * dx + dy * dy))) return null;
    }
    for (const field of this.fields) {
      const dx = Math.max(0, line - field.x, field.x - end);
      const dy = Math.max(0, places[0] - field.y, field.y - places[1]);
      if (surelyLess(field.radius + SLACK, Math.sqrt(dx * dx + dy * dy))) continue;
      if (line - field.x < NEAREST) return null;
      pushes.push({ centre: field, towards: false, from: places[0], to: places[1] });
    }
    this.comparisons += this.asteroids.length;
    let reach = Number.POSITIVE_INFINITY;
    for (const [i, { x, y }] of this.asteroids.entries()) {
      if (i === this.before) continue;
      const dx = Math.max(end - x, x - line);
      const dy = Math.max(places[1] - y, y - places[0]);
      reach = Math.min(reach, Math.sqrt(dx * dx + dy * dy));
    }
    const near = this.asteroids.filter(({ x, y }, i) => {
      const dx = Math.max(0, line - x, x - end);
      const dy = Math.max(0, places[0] - y, y - places[1]);
      return i !== this.before && Math.sqrt(dx * dx + dy * dy) <= reach + SLACK;
    });
    this.comparisons += near.length * near.length;
    if (this.comparisons > MOST_COMPARISONS) return null;
    for (const centre of near) {
      const [from, to] = nearestWithin(centre, near, line, places);
      if (from > to) continue;
      if (centre.x - end < NEAREST) return null;
      pushes.push({ centre, towards: true, from, to });
    }
    return pushes;
  }

  /** The parts of a front that are not stopped at this line. */
  private notOver({ ways, box }: Front, line: number): Front[] {
    const [least, most] = spanOf(ways.map(({ x }) => x));
    const [first, last] = box.map(directionOf);
    const near = this.circles.filter(({ x, y, radius }) => {
      const reach = radius + this.box.halfDiagonal;
      return Math.abs(x - line) < reach && y + reach > least && y - reach < most;
    });
    const left: [from: number, to: number][] = [];
    for (let piece = Math.floor(least / PIECE); piece * PIECE <= most; piece++) {
      const from = Math.max(least, piece * PIECE);
      const to = Math.min(most, (piece + 1) * PIECE);
      const ends = [
        { x: line, y: from },
        { x: line, y: to },
      ];
      if (near.some((circle) => this.isStopped(circle, ends, first, last)) || this.isLost(line, from, to)) continue;
      const before = left[left.length - 1];
      if (before?.[1] === from) before[1] = to;
      else left.push([from, to]);
    }
    return left.map(([from, to]) => ({ ways: from === least && to === most ? ways : between(ways, from, to), box }));
  }

  /** Whether a circle overlaps her box at all places between two, with its axis in any direction between two unit vectors. */
  private isStopped(circle: StandingCircle, ends: readonly Place[], from: Place, to: Place): boolean {
    const { box } = this;
    const far = Math.max(...ends.map((p) => distance(p, circle)));
    if (far < circle.radius + this.leastHalf - DEEP) return true;
    if (far > circle.radius + box.halfDiagonal) return false;
    const sum = { x: from.x + to.x, y: from.y + to.y };
    const length = Math.sqrt(sum.x * sum.x + sum.y * sum.y);
    const middle = { x: sum.x / length, y: sum.y / length };
    const chord = Math.max(distance(middle, from), distance(middle, to));
    const gaps = ends.map((p) => boxCircleGap(box, circle.x - p.x, circle.y - p.y, middle.x, middle.y, circle.radius));
    const worst = Math.max(...gaps);
    if (worst < -DEEP - box.halfDiagonal * chord) return true;
    if (worst > -DEEP || chord < FINEST_TURN) return false;
    return this.isStopped(circle, ends, from, middle) && this.isStopped(circle, ends, middle, to);
  }

  private isLost(line: number, from: number, to: number): boolean {
    return this.asteroids.every(({ x, y }) => {
      const dy = Math.max(0, from - y, y - to);
      return surelyLess(this.range + DEEP, Math.sqrt((line - x) * (line - x) + dy * dy));
    });
  }
}

/** The places across, over one step, at which an asteroid may be the nearest. */
function nearestWithin(rock: Place, others: readonly Place[], line: number, places: Span): Span {
  let [from, to] = places;
  for (const other of others) {
    if (other === rock) continue;
    const x = other.x - rock.x;
    const y = other.y - rock.y;
    // It is nearer than the other where 2 p (other - rock) <= |other|² - |rock|².
    const apart = x * (other.x + rock.x) + y * (other.y + rock.y);
    const most = apart - 2 * x * (x > 0 ? line : line + STEP) + margin(apart, x * line);
    if (y > 0) to = Math.min(to, most / (2 * y) + SLACK);
    else if (y < 0) from = Math.max(from, most / (2 * y) - SLACK);
    else if (most < 0) return [1, 0];
    if (from > to) break;
  }
  return [from, to];
}

/**
 * Propagates places and slopes by one step. If the pushes on the way have slopes within a span, her slope stays between its old
 * value and that span, or within the span once it has entered it. Her place moves by the step times the mean slope.
 * @param aside how far across she may come within the step, px
 */
function pushed(ways: readonly Vertex[], places: Span, line: number, aside: number, pushes: readonly Push[]) {
  const points: Vertex[] = ways.map(({ x, y }) => ({ x: x + STEP * y, y }));
  let pulls: Span | null = null;
  const cuts = [...places, ...pushes.flatMap(({ from, to }) => [from - aside, to + aside])]
    .filter((cut) => cut >= places[0] && cut <= places[1])
    .sort((a, b) => a - b);
  for (const [n, from] of cuts.slice(0, -1).entries()) {
    const to = cuts[n + 1];
    const acting = pushes.filter((push) => push.from - aside <= from && push.to + aside >= to);
    if (acting.length === 0) continue;
    const piece = between(ways, from, to);
    for (const { x, y } of piece) {
      for (const slope of slopesAt(x, line, aside, acting)) points.push({ x: x + STEP * y, y: slope });
    }
    for (const x of spanOf(piece.map((p) => p.x))) {
      const span = slopesAt(x, line, aside, acting);
      for (const mean of span) for (const slope of span) points.push({ x: x + STEP * mean, y: slope });
      const rocks = acting.filter(({ towards }) => towards);
      if (rocks.length === 0) continue;
      const pull = slopesAt(x, line, aside, rocks);
      pulls = pulls === null ? pull : join(pulls, pull);
    }
  }
  const after = convexHull(points);
  return { ways: after, slopes: spanOf(after.map(({ y }) => y)), pulls };
}

/** The slopes of the pushes in a step that begins at a place across. */
function slopesAt(place: number, line: number, aside: number, pushes: readonly Push[]): Span {
  let least = Number.POSITIVE_INFINITY;
  let most = Number.NEGATIVE_INFINITY;
  for (const { centre, towards } of pushes) {
    for (const x of [line, line + STEP]) {
      const slope = (centre.y - place) / (centre.x - x);
      const more = aside / Math.abs(centre.x - (towards ? line + STEP : line)) + SLACK;
      least = Math.min(least, slope - more);
      most = Math.max(most, slope + more);
    }
  }
  return [least, most];
}

/** The unit vector of a slope. */
function directionOf(slope: number): Place {
  const length = Math.sqrt(1 + slope * slope);
  return { x: 1 / length, y: slope / length };
}

const join = (a: Span, b: Span): Span => [Math.min(a[0], b[0]), Math.max(a[1], b[1])];

function spanOf(values: readonly number[]): Span {
  let least = Number.POSITIVE_INFINITY;
  let most = Number.NEGATIVE_INFINITY;
  for (const value of values) {
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return [least, most];
}

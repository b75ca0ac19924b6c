import { TICK } from '../../engine/index.ts';
import type { Disc, Place } from '../../schema/basics/index.ts';
import type { Flowpipe, PipeGrid, PipePart, PipeStep, Strip } from '../prove/index.ts';
import { farFromLimit } from './assumptions.ts';
import { afterChase, type Chaser, eitherChaser } from './chasers.ts';
import { type Claim, standingHazard } from './claim.ts';
import { apart, isIndex } from './geometry.ts';
import { isAxis, isCount, isFrom, type TurnedScene, turnedScene } from './turned-scene.ts';

/** Far more than the rounding error of one step, px. */
const ROUNDING = 1e-7;

/** How late the engine may notice that she crosses a rim, px. */
const ON_RIM = 1e-6;

/** The most parts of sets in a certificate, and the largest number, px. */
const MOST = 100_000;
const LARGEST = 1e9;

/** The number of directions; direction n + 4 is opposite to direction n. */
const AROUND = 8;
const HALF_ROOT = Math.sqrt(0.5);
const COMPASS: readonly Place[] = [
  { x: 1, y: 0 },
  { x: HALF_ROOT, y: HALF_ROOT },
  { x: 0, y: 1 },
  { x: -HALF_ROOT, y: HALF_ROOT },
  { x: -1, y: 0 },
  { x: -HALF_ROOT, y: -HALF_ROOT },
  { x: 0, y: -1 },
  { x: HALF_ROOT, y: -HALF_ROOT },
];
const back = (n: number): number => (n + 4) % AROUND;

/** All places with `left <= x <= right` and `low <= y <= high`. */
interface Area {
  readonly left: number;
  readonly right: number;
  readonly low: number;
  readonly high: number;
}

/**
 * The x axis of her box points along `to`, or the other way, or deviates from either by a chord of at most `off`; every
 * direction is within 2.
 */
interface Aim {
  readonly to: Place;
  readonly off: number;
}

/** An octagon: its greatest extent in each of the eight directions, px. */
type Octagon = readonly number[];

/**
 * A set of states, described by drift places: `atTimes[i]` contains the place where she would be at time i if she drifted from
 * now on. Octagons that are no longer needed are null.
 */
interface Bundle {
  readonly atTimes: readonly (Octagon | null)[];
  readonly aim: Aim;
  readonly chasers: readonly Chaser[];
}

/**
 * Checks `flowpipe`: it computes reachable sets in continuous time from the hints of the certificate, until nothing is left.
 *
 * States are described by the octagons in which a drift from now on would be at the times between the steps. A push a(s) shifts
 * the drift place of time t by the integral of (t - s) a(s), so one step widens each octagon by the pushes that are possible at
 * the places of the step (lemma `pushes`). While she drifts, nothing changes, so the dependence of place and velocity is
 * preserved. The angle of her box is known as well: after a press it points at the target.
 *
 * The hints say where sets are cut, which strips hazards take off, and which parts are joined. Each hint is tested and nothing
 * is searched for: all sides of a cut are accounted for; her box overlaps the hazard at all corners of a strip; what is said to
 * have ended is empty or out of range. No place of a step may be near the object, a wind or a mouth.
 */
export function checkFlowpipe(claim: Claim, { grid, layers }: Flowpipe): string | null {
  if (claim.frames) return 'with frames pushes and contacts happen only once a frame';
  if (!isGrid(grid)) return 'its grid is not valid';
  if (!Array.isArray(layers)) return 'its steps are not valid';
  const seconds = grid.frames * TICK;
  const { vx, vy } = claim.level.astronaut;
  if (Math.sqrt(vx * vx + vy * vy) + (claim.push + claim.blur) * seconds * grid.steps > farFromLimit(claim.rules))
    return 'she may reach the speed limit';
  const scene: Scene = { ...turnedScene(claim, grid.axis), claim, seconds, times: [Math.floor(grid.steps / 3), grid.steps] };
  let bundles: ReadonlyMap<number, Bundle> = new Map([[0, startOf(scene)]]);
  let made = 0;
  for (let step = 1; bundles.size > 0; step++) {
    const goOn = `some runs may continue after ${step - 1} steps`;
    if (step > grid.steps) return goOn;
    const ways = new Map([...bundles].map(([k, bundle]) => [k, wayTo(bundle, step, seconds, claim.push + claim.blur)]));
    for (const way of ways.values()) {
      if (!(distances(scene.thing, way).least > claim.touch + ROUNDING)) return `she may touch it in step ${step}`;
      const mayEnter = (disc: Disc) => !(distances(disc, way).least > disc.radius + ON_RIM);
      if (scene.winds.some(mayEnter)) return `a wind may act on her in step ${step}`;
      if (scene.mouths.some(mayEnter)) return `she may enter a wormhole in step ${step}`;
    }
    if (step > layers.length) return goOn;
    const next = new Map<number, Bundle>();
    for (const [k, bundle] of bundles) {
      for (const [n, after] of afterStep(scene, bundle, ways.get(k) as Area, step).entries()) {
        const pieces = piecesOf(scene, after, step, layers[step - 1]?.[k]?.[n]);
        if (pieces === null) return `it does not say how a set continues in step ${step}`;
        made += pieces.length;
        if (made > MOST) return 'following her takes too many pieces';
        const why = takeOver(scene, pieces, step, next);
        if (why !== null) return why;
      }
    }
    bundles = next;
  }
  return null;
}

/**
 * Joins the remaining parts of a set to the sets of the next step. Returns what is wrong if a part goes on that is said to have
 * ended.
 */
function takeOver(scene: Scene, pieces: readonly Piece[], step: number, next: Map<number, Bundle>): string | null {
  for (const { piece, off, to } of pieces) {
    const left = piece && withoutStrips(scene, piece, off, step);
    if (left === null) continue;
    if (typeof left === 'string') return left;
    if (to === null && !isLost(scene, left, step)) return `a part that it says is over continues after step ${step}`;
    if (to === null) continue;
    const there = next.get(to);
    next.set(to, there === undefined ? left : either(there, left));
  }
  return null;
}

const isGrid = (grid: PipeGrid | undefined): grid is PipeGrid =>
  isAxis(grid?.axis) &&
  isCount(1, 60, grid?.frames) &&
  isCount(3, 400, grid?.steps) &&
  // The checker does not need these numbers, but a picture of the proof is computed from them.
  isFrom(0.25, 1000, grid?.cell) &&
  isCount(1, 64, grid?.turns);

interface Scene extends TurnedScene {
  readonly claim: Claim;
  /** Length of a step, s. */
  readonly seconds: number;
  /** The two times at whose octagons sets are cut. */
  readonly times: readonly [number, number];
}

/** The start, as one set. */
function startOf({ claim, seconds, times, velocity, turn }: Scene): Bundle {
  const octagonAt = (time: number): Octagon =>
    COMPASS.map((d) => dot(d, { x: velocity.x * time * seconds, y: velocity.y * time * seconds }) + ROUNDING);
  return {
    atTimes: Array.from({ length: times[1] + 1 }, (_, i) => octagonAt(i)),
    aim: { to: turn({ x: 1, y: 0 }), off: ROUNDING },
    chasers: claim.level.aliens.map((alien) => ({
      at: { centre: turn(claim.place(alien)), within: 0 },
      speed: { centre: { x: 0, y: 0 }, within: 0 },
      radius: alien.radius,
      isThere: true,
    })),
  };
}

/** Where she may be in a step: the drift between its two ends, and how far pushes can take her from that. */
function wayTo({ atTimes }: Bundle, step: number, seconds: number, push: number): Area {
  const before = atTimes[step - 1] as Octagon;
  const after = atTimes[step] as Octagon;
  // A stage of a stepping method may also lie beside the path.
  const bend = (push * seconds * seconds) / 2 + Math.max(0.01, 2.5e-4 * push);
  const most = (n: number) => Math.max(before[n], after[n]) + bend;
  return { left: -most(4), right: most(0), low: -most(6), high: most(2) };
}

/** What may become of a set: pressed at some time of the step, or not at all. */
function afterStep(scene: Scene, bundle: Bundle, way: Area, step: number): Bundle[] {
  const { seconds } = scene;
  const { pull, aim } = gun(scene, way, step * seconds);
  const field = fieldsAt(scene, way);
  const chasers = afterChase(scene.claim.rules, bundle.chasers, way, seconds);
  const zero = COMPASS.map(() => 0);
  const free = field === null ? null : field.always ? field.push : most(field.push, zero);
  const held = field?.always === true ? field.push : most(most(pull, zero), free ?? zero);
  const pressed = held.map((force) => force + scene.claim.blur);
  const pushed = (forces: readonly number[]) =>
    bundle.atTimes.map((octagon, i) => {
      if (octagon === null || (i < step && !scene.times.includes(i))) return null;
      // The integral of the time left to time i. For a time that has passed, the push counts the other way.
      const lever = seconds * seconds * (i - step + 0.5);
      return octagon.map((far, n) => far + (lever > 0 ? lever * forces[n] : -lever * forces[back(n)]) + ROUNDING);
    });
  return [
    { atTimes: pushed(pressed), aim, chasers },
    { atTimes: free === null ? bundle.atTimes : pushed(free), aim: bundle.aim, chasers },
  ];
}

const most = (a: readonly number[], b: readonly number[]): number[] => a.map((far, n) => Math.max(far, b[n]));

/**
 * The greatest acceleration by the gun in each direction, at any place of the step, and where her box points while the gun is
 * held.
 */
function gun({ claim, asteroids: rocks, drift }: Scene, way: Area, seconds: number): { pull: readonly number[]; aim: Aim } {
  const { range, recoil } = claim.level;
  const strongest = claim.rules.pull;
  const middle = middleOf(way);
  const nearest = rocks.reduce((best, rock) => (apart(rock, middle) < apart(best, middle) ? rock : best), rocks[0]);
  const reach = rocks.reduce(
    (least, rock, i) => Math.min(least, distances(rock, way).most + drift(i, seconds)),
    Number.POSITIVE_INFINITY,
  );
  const corners = cornersOf(way);
  let pull: readonly number[] = COMPASS.map(() => Number.NEGATIVE_INFINITY);
  let aim: Aim | null = null;
  for (const [i, rock] of rocks.entries()) {
    const moved = drift(i, seconds);
    const { least, most: farthest } = distances(rock, way);
    if (least - moved > reach + ROUNDING) continue;
    // Without recoil the border between two targets is a straight line.
    const isBeaten = !recoil && corners.every((p) => apart(p, nearest) + 10 * ROUNDING < apart(p, rock));
    if (rock !== nearest && isBeaten) continue;
    const way0 = { x: rock.x - middle.x, y: rock.y - middle.y };
    const d = apart(rock, middle);
    const blur = halfDiagonal(way) + moved + ROUNDING;
    if (d - blur < 4) return { pull: COMPASS.map(() => strongest), aim: { to: { x: 1, y: 0 }, off: 2 } };
    const perPx = (at: number) => Math.max(0, strongest / at - strongest / range);
    // How much the pull changes per px of her place: tangentially by what is left of pull / d, radially by pull / range.
    const slope = Math.max(strongest / (d - blur), strongest / range);
    pull = most(
      pull,
      COMPASS.map((direction) => {
        const ahead = Math.max(...corners.map((p) => dot(direction, { x: rock.x - p.x, y: rock.y - p.y }))) + moved;
        const byPlace = ahead * perPx(ahead > 0 ? least - moved : farthest + moved);
        return Math.min(byPlace, perPx(d) * dot(direction, way0) + slope * blur) + ROUNDING;
      }),
    );
    // If the sine of an angle is at most 1/2, its chord is at most 1.04 times the sine.
    const here: Aim =
      blur > d / 2 ? { to: { x: 1, y: 0 }, off: 2 } : { to: { x: way0.x / d, y: way0.y / d }, off: (1.1 * blur) / d };
    aim = aim === null ? here : eitherAim(aim, here);
  }
  return { pull, aim: aim ?? { to: { x: 1, y: 0 }, off: 2 } };
}

/** The greatest acceleration by fields in each direction; null when she is out of all fields. */
function fieldsAt({ claim, fields }: Scene, way: Area): { push: readonly number[]; always: boolean } | null {
  const middle = middleOf(way);
  const blur = halfDiagonal(way) + ROUNDING;
  const strongest = claim.rules.push;
  const near = fields.filter((field) => distances(field, way).least <= field.radius + ROUNDING);
  if (near.length === 0) return null;
  const pushes = near.map((field) => {
    const d = apart(field, middle);
    return COMPASS.map((direction) => {
      if (d - blur < 2) return strongest;
      const there = (strongest * dot(direction, { x: middle.x - field.x, y: middle.y - field.y })) / d;
      return Math.min(strongest, there + (strongest * blur) / (d - blur)) + ROUNDING;
    });
  });
  return { push: pushes.reduce(most), always: near.some((field) => distances(field, way).most < field.radius - ROUNDING) };
}

/** A part of a set, null when it is empty, and the hint about it. */
type Piece = PipePart & { readonly piece: Bundle | null };

/** A set, cut by its drift places at two times as the certificate says; null when the hint makes no sense. */
function piecesOf({ times }: Scene, bundle: Bundle, step: number, said: PipeStep | undefined): Piece[] | null {
  if (!Array.isArray(said?.cuts) || said.cuts.length !== 4 || !Array.isArray(said.parts)) return null;
  const { cuts, parts } = said;
  if (!cuts.every((lines) => Array.isArray(lines) && lines.every(isLength)) || !parts.every(isPart)) return null;
  if (parts.length > MOST || cuts.reduce((count, lines) => count * (lines.length + 1), 1) !== parts.length) return null;
  // The first and the last interval are unbounded, so that the intervals contain everything.
  const between = cuts.map((lines) =>
    [...lines, Number.POSITIVE_INFINITY].map((to, n) => [n > 0 ? lines[n - 1] : Number.NEGATIVE_INFINITY, to]),
  );
  const cells = between.reduce<number[][][]>((all, some) => all.flatMap((one) => some.map((w) => [...one, w])), [[]]);
  const isWhole = parts.length === 1;
  return cells.map((cell, n) => ({ ...parts[n], piece: isWhole ? bundle : within(bundle, times, cell, step) }));
}

const isLength = (n: unknown): n is number => isFrom(-LARGEST, LARGEST, n);

const isPart = (part: PipePart | undefined): part is PipePart =>
  Array.isArray(part?.off) &&
  part.off.every((strip) => isIndex(strip?.side, COMPASS) && isLength(strip.at)) &&
  (part.to === null || (Number.isInteger(part.to) && part.to >= 0));

/** The part of a set between given lines at two times, along x and y at each; null when it is empty. */
function within(bundle: Bundle, times: readonly number[], cell: readonly number[][], step: number): Bundle | null {
  const limit = times.map((time, n) => {
    const [right, , high, , left, , low] = bundle.atTimes[time] as Octagon;
    const [[fromX, toX], [fromY, toY]] = cell.slice(2 * n);
    const most = { x: Math.min(right, toX), y: Math.min(high, toY) };
    const least = { x: Math.max(-left, fromX), y: Math.max(-low, fromY) };
    return COMPASS.map(({ x, y }) => x * (x > 0 ? most.x : least.x) + y * (y > 0 ? most.y : least.y));
  });
  const atTimes = bundle.atTimes.map((octagon, i) => {
    if (octagon === null || (i < step && !times.includes(i))) return null;
    // A drift is a straight line: its place at one time follows from its places at two others.
    const share = (times[1] - i) / (times[1] - times[0]);
    const part = (weight: number, of: readonly number[], n: number) => (weight >= 0 ? weight * of[n] : -weight * of[back(n)]);
    return octagon.map((far, n) => Math.min(far, part(share, limit[0], n) + part(1 - share, limit[1], n) + ROUNDING));
  });
  return atTimes.some((octagon) => octagon?.some((far, n) => far + octagon[back(n)] < -ROUNDING)) ? null : { ...bundle, atTimes };
}

/**
 * A set without the strips in which hazards end the run, with the hazards as they are at the end of a step; null when nothing
 * is left, or what is wrong if one of the strips goes on.
 */
function withoutStrips(scene: Scene, bundle: Bundle, off: readonly Strip[], step: number): Bundle | string | null {
  let octagon = bundle.atTimes[step] as Octagon;
  for (const { by, side, at } of off) {
    const hazard = hazardAt(scene, bundle, by, step * scene.seconds);
    if (hazard === null) return 'it names a hazard that the level does not have';
    const nearest = Math.max(at, -octagon[back(side)]);
    const [a, b] = [COMPASS[side], COMPASS[(side + 2) % AROUND]];
    const corners = [octagon[side], nearest].flatMap((far) =>
      [octagon[(side + 2) % AROUND], -octagon[(side + 6) % AROUND]].map((next) => ({
        x: a.x * far + b.x * next,
        y: a.y * far + b.y * next,
      })),
    );
    if (!overlapsAll(scene.claim, hazard, corners, bundle.aim)) return `a hazard may not stop her after step ${step}`;
    if (at <= -octagon[back(side)]) return null;
    octagon = octagon.map((far, n) => (n === side ? Math.min(far, at + ROUNDING) : far));
  }
  return { ...bundle, atTimes: bundle.atTimes.map((old, i) => (i === step ? octagon : old)) };
}

/** The circle that a hazard covers after so many seconds; null when the object is no hazard or may be gone. */
function hazardAt({ claim, turn, drift }: Scene, { chasers }: Bundle, by: Strip['by'], seconds: number): Disc | null {
  if (by?.kind === 'alien') {
    if (!isIndex(by.index, chasers) || !chasers[by.index].isThere) return null;
    const { at, radius } = chasers[by.index];
    return { ...at.centre, radius: radius - at.within };
  }
  const hazard = standingHazard({ ...claim, drift: (i) => drift(i, seconds) }, by);
  return hazard && { ...turn(hazard), radius: hazard.radius };
}

/**
 * Whether her box overlaps a circle at all places between some corners, either by the circle in her box or by the box at its
 * possible angles. In both cases these places form a convex set, so it contains everything between its corners.
 */
function overlapsAll({ box, inner }: Claim, { x, y, radius }: Disc, corners: readonly Place[], { to, off }: Aim): boolean {
  const inCircle = (p: Place) => apart(p, { x, y }) < radius + inner - ROUNDING;
  const inBox = (p: Place) => {
    const way = { x: x - p.x, y: y - p.y };
    const beyond = {
      x: Math.max(0, Math.abs(dot(way, to)) - box.halfWidth),
      y: Math.max(0, Math.abs(way.y * to.x - way.x * to.y) - box.halfHeight),
    };
    return apart(beyond, { x: 0, y: 0 }) + box.halfDiagonal * off < radius - ROUNDING;
  };
  return corners.every(inCircle) || corners.every(inBox);
}

/** Whether all of a set is out of range at the end of a step. */
function isLost({ asteroids, drift, seconds }: Scene, { atTimes }: Bundle, step: number): boolean {
  const [right, , high, , left, , low] = atTimes[step] as Octagon;
  const here: Area = { left: -left, right, low: -low, high };
  return asteroids.every((rock, i) => distances(rock, here).least > rock.radius + drift(i, step * seconds) + ROUNDING);
}

/** A set that contains two others. */
function either(a: Bundle, b: Bundle): Bundle {
  return {
    atTimes: a.atTimes.map((octagon, i) => {
      const other = b.atTimes[i];
      return octagon === null || other === null ? null : most(octagon, other);
    }),
    aim: eitherAim(a.aim, b.aim),
    chasers: a.chasers.map((chaser, i) => eitherChaser(chaser, b.chasers[i])),
  };
}

/** Half a turn does not change her box. */
function eitherAim(a: Aim, b: Aim): Aim {
  const sign = dot(a.to, b.to) < 0 ? -1 : 1;
  const other = { x: sign * b.to.x, y: sign * b.to.y };
  const sum = { x: a.to.x + other.x, y: a.to.y + other.y };
  const size = apart(sum, { x: 0, y: 0 });
  const to = { x: sum.x / size, y: sum.y / size };
  return { to, off: Math.min(2, Math.max(apart(to, a.to) + a.off, apart(to, other) + b.off) + 1e-12) };
}

const dot = (a: Place, b: Place): number => a.x * b.x + a.y * b.y;
const middleOf = ({ left, right, low, high }: Area): Place => ({ x: (left + right) / 2, y: (low + high) / 2 });
const halfDiagonal = ({ left, right, low, high }: Area): number => apart({ x: left, y: low }, { x: right, y: high }) / 2;
const cornersOf = ({ left, right, low, high }: Area): Place[] => [left, right].flatMap((x) => [low, high].map((y) => ({ x, y })));

/** Distances from a place to the nearest and to the farthest place of an area. */
function distances(p: Place, area: Area): { least: number; most: number } {
  const beside = { x: Math.max(0, area.left - p.x, p.x - area.right), y: Math.max(0, area.low - p.y, p.y - area.high) };
  return { least: apart(beside, { x: 0, y: 0 }), most: Math.max(...cornersOf(area).map((corner) => apart(corner, p))) };
}

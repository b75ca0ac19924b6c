import { TICK } from '../../engine/index.ts';
import type { Flowpipe, PipeGrid, PipePart, PipeStep, Strip } from '../proofs/index.ts';
import { farFromLimit } from './assumptions.ts';
import { afterChase, type Chaser, eitherChaser } from './chasers.ts';
import type { Claim } from './claim.ts';
import { standingHazard } from './hazards.ts';
import { apart, isIndex, type Point } from './rounded.ts';
import { type Circle, isAxis, isCount, isFrom, type TurnedScene, turnedScene } from './turned-scene.ts';

/** Rounding of a step is far below this, px. */
const ROUNDING = 1e-7;

/** She may cross a rim by so much late, px. */
const ON_RIM = 1e-6;

/** A certificate may have no more parts of sets than this, nor larger numbers, px. */
const MOST = 25_000;
const LARGEST = 1e9;

/** Eight directions around; that of n + 4 is opposite to n. */
const AROUND = 8;
const HALF_ROOT = Math.sqrt(0.5);
const COMPASS: readonly Point[] = [
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

/** The x axis of her box points along `to`, the other way, or within a chord of `off` of either; all directions are within 2. */
interface Aim {
  readonly to: Point;
  readonly off: number;
}

/** An octagon: how far it goes at most in each direction of the compass, px. */
type Octagon = readonly number[];

/**
 * States with which she would be within an octagon at each of several times if she drifted, `atTimes[i]` that of time i; those that
 * nothing asks for any more are null.
 */
interface Bundle {
  readonly atTimes: readonly (Octagon | null)[];
  readonly aim: Aim;
  readonly chasers: readonly Chaser[];
}

/**
 * Follows all that she may do in continuous time, in steps of some ticks. States are known by the octagons in which a drift from now on would be at the times
 * between the steps: a push a(s) moves the drift to time t by the integral of (t - s) a(s). The certificate says where bundles are cut, which strips hazards take
 * off, and which bundles are joined: all of that is tested, and nothing looked for. No drift and push of a step may come near the thing, and at the end no
 * bundle may be left.
 */
export function checkFlowpipe(claim: Claim, { grid, layers }: Flowpipe): string | null {
  if (claim.frames) return 'with frames she is pushed and looked at once a frame only';
  if (!isGrid(grid)) return 'its grid is none';
  if (!Array.isArray(layers)) return 'its steps are none';
  const seconds = grid.frames * TICK;
  const { vx, vy } = claim.level.astronaut;
  if (Math.sqrt(vx * vx + vy * vy) + claim.push * seconds * grid.steps > farFromLimit(claim.rules))
    return 'she may come to the speed limit';
  const scene: Scene = { ...turnedScene(claim, grid.axis), claim, seconds, times: [Math.floor(grid.steps / 3), grid.steps] };
  let bundles: ReadonlyMap<number, Bundle> = new Map([[0, startOf(scene)]]);
  let made = 0;
  for (let step = 1; bundles.size > 0; step++) {
    const goOn = `some runs may go on after ${step - 1} steps`;
    if (step > grid.steps) return goOn;
    const ways = new Map([...bundles].map(([k, bundle]) => [k, wayTo(bundle, step, seconds, claim.push)]));
    for (const way of ways.values()) {
      if (!(distances(scene.thing, way).least > claim.touch + ROUNDING)) return `she may touch it in step ${step}`;
      const mayEnter = (disc: Circle) => !(distances(disc, way).least > disc.radius + ON_RIM);
      if (scene.winds.some(mayEnter)) return `a wind may blow on her in step ${step}`;
      if (scene.mouths.some(mayEnter)) return `she may come to a wormhole in step ${step}`;
    }
    if (step > layers.length) return goOn;
    const next = new Map<number, Bundle>();
    for (const [k, bundle] of bundles) {
      for (const [n, after] of afterStep(scene, bundle, ways.get(k) as Area, step).entries()) {
        const pieces = piecesOf(scene, after, step, layers[step - 1]?.[k]?.[n]);
        if (pieces === null) return `it does not say how a set goes on in step ${step}`;
        made += pieces.length;
        if (made > MOST) return 'it takes too many pieces to follow her';
        const why = takeOver(scene, pieces, step, next);
        if (why !== null) return why;
      }
    }
    bundles = next;
  }
  return null;
}

/** Joins what is left of the parts of a bundle to the bundles of the next step; why not, where some of it goes on that is said to be over. */
function takeOver(scene: Scene, pieces: readonly Piece[], step: number, next: Map<number, Bundle>): string | null {
  for (const { piece, off, to } of pieces) {
    const left = piece && withoutStrips(scene, piece, off, step);
    if (left === null) continue;
    if (typeof left === 'string') return left;
    if (to === null && !isLost(scene, left, step)) return `some of what it calls over goes on after step ${step}`;
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
  // by these the certificate was made: a picture of it is made again
  isFrom(0.25, 1000, grid?.cell) &&
  isCount(1, 64, grid?.turns);

interface Scene extends TurnedScene {
  readonly claim: Claim;
  /** length of a step, s */
  readonly seconds: number;
  /** the two times by whose octagons bundles are cut */
  readonly times: readonly [number, number];
}

/** All she is at the start: one bundle. */
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

/** Where she may be in a step: the drift between its two ends, and how far a push can take her from that. */
function wayTo({ atTimes }: Bundle, step: number, seconds: number, push: number): Area {
  const before = atTimes[step - 1] as Octagon;
  const after = atTimes[step] as Octagon;
  // and what a stage of a method that steps may be off the way
  const bend = (push * seconds * seconds) / 2 + Math.max(0.01, 2.5e-4 * push);
  const most = (n: number) => Math.max(before[n], after[n]) + bend;
  return { left: -most(4), right: most(0), low: -most(6), high: most(2) };
}

/** What may become of a bundle: pressed at some time of the step, or not at all. */
function afterStep(scene: Scene, bundle: Bundle, way: Area, step: number): Bundle[] {
  const { seconds } = scene;
  const { pull, aim } = gun(scene, way, step * seconds);
  const field = fieldsAt(scene, way);
  const chasers = afterChase(scene.claim.rules, bundle.chasers, way, seconds);
  const zero = COMPASS.map(() => 0);
  const free = field === null ? null : field.always ? field.push : most(field.push, zero);
  const pressed = field?.always === true ? field.push : most(most(pull, zero), free ?? zero);
  const pushed = (forces: readonly number[]) =>
    bundle.atTimes.map((octagon, i) => {
      if (octagon === null || (i < step && !scene.times.includes(i))) return null;
      // the integral of the time left to time i; where that has passed, the push counts the other way
      const lever = seconds * seconds * (i - step + 0.5);
      return octagon.map((far, n) => far + (lever > 0 ? lever * forces[n] : -lever * forces[back(n)]) + ROUNDING);
    });
  return [
    { atTimes: pushed(pressed), aim, chasers },
    { atTimes: free === null ? bundle.atTimes : pushed(free), aim: bundle.aim, chasers },
  ];
}

const most = (a: readonly number[], b: readonly number[]): number[] => a.map((far, n) => Math.max(far, b[n]));

/** How far the gun can accelerate her in each direction, wherever she is on the way, and where her box points while it is held. */
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
    // without recoil the border between two targets is a straight line
    const isBeaten = !recoil && corners.every((p) => apart(p, nearest) + 10 * ROUNDING < apart(p, rock));
    if (rock !== nearest && isBeaten) continue;
    const way0 = { x: rock.x - middle.x, y: rock.y - middle.y };
    const d = apart(rock, middle);
    const blur = halfDiagonal(way) + moved + ROUNDING;
    if (d - blur < 4) return { pull: COMPASS.map(() => strongest), aim: { to: { x: 1, y: 0 }, off: 2 } };
    const perPx = (at: number) => Math.max(0, strongest / at - strongest / range);
    // how much the pull changes with a px of her place: tangentially by what is left of pull / d, radially by pull / range
    const slope = Math.max(strongest / (d - blur), strongest / range);
    pull = most(
      pull,
      COMPASS.map((direction) => {
        const ahead = Math.max(...corners.map((p) => dot(direction, { x: rock.x - p.x, y: rock.y - p.y }))) + moved;
        const byPlace = ahead * perPx(ahead > 0 ? least - moved : farthest + moved);
        return Math.min(byPlace, perPx(d) * dot(direction, way0) + slope * blur) + ROUNDING;
      }),
    );
    // the chord of an angle whose sine is at most a half is at most 1.04 times that sine
    const here: Aim =
      blur > d / 2 ? { to: { x: 1, y: 0 }, off: 2 } : { to: { x: way0.x / d, y: way0.y / d }, off: (1.1 * blur) / d };
    aim = aim === null ? here : eitherAim(aim, here);
  }
  return { pull, aim: aim ?? { to: { x: 1, y: 0 }, off: 2 } };
}

/** How far fields can push her in each direction; null out of all of them. */
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

/** A part of a bundle, null where there is none, and what is said of it. */
type Piece = PipePart & { readonly piece: Bundle | null };

/** A bundle cut by its places at two times, as the certificate says; null where it says nothing that makes sense. */
function piecesOf({ times }: Scene, bundle: Bundle, step: number, said: PipeStep | undefined): Piece[] | null {
  if (!Array.isArray(said?.cuts) || said.cuts.length !== 4 || !Array.isArray(said.parts)) return null;
  const { cuts, parts } = said;
  if (!cuts.every((lines) => Array.isArray(lines) && lines.every(isLength)) || !parts.every(isPart)) return null;
  if (parts.length > MOST || cuts.reduce((count, lines) => count * (lines.length + 1), 1) !== parts.length) return null;
  // from one line to the next, the first and the last without end: all that there is lies in one of them
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

/** What of a bundle is between some lines at two times, along x and y at each; null when nothing is. */
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
    // a drift is a straight line: its place at one time follows from those at two
    const share = (times[1] - i) / (times[1] - times[0]);
    const part = (weight: number, of: readonly number[], n: number) => (weight >= 0 ? weight * of[n] : -weight * of[back(n)]);
    return octagon.map((far, n) => Math.min(far, part(share, limit[0], n) + part(1 - share, limit[1], n) + ROUNDING));
  });
  return atTimes.some((octagon) => octagon?.some((far, n) => far + octagon[back(n)] < -ROUNDING)) ? null : { ...bundle, atTimes };
}

/** A bundle without strips in which hazards end the run, as they are at the end of a step; null when nothing is left, or why one of them goes on. */
function withoutStrips(scene: Scene, bundle: Bundle, off: readonly Strip[], step: number): Bundle | string | null {
  let octagon = bundle.atTimes[step] as Octagon;
  for (const { by, side, at } of off) {
    const hazard = hazardAt(scene, bundle, by, step * scene.seconds);
    if (hazard === null) return 'it names a hazard that there is not';
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

/** The circle that something deadly covers after so many seconds; null where it is nothing of that sort, or may be there no more. */
function hazardAt({ claim, turn, drift }: Scene, { chasers }: Bundle, by: Strip['by'], seconds: number): Circle | null {
  if (by?.kind === 'alien') {
    if (!isIndex(by.index, chasers) || !chasers[by.index].isThere) return null;
    const { at, radius } = chasers[by.index];
    return { ...at.centre, radius: radius - at.within };
  }
  const hazard = standingHazard({ ...claim, drift: (i) => drift(i, seconds) }, by);
  return hazard && { ...turn(hazard), radius: hazard.radius };
}

/**
 * Whether her box overlaps a circle wherever she is between some corners: by the circle in her box, or by the box as it is turned. Both times these places are
 * convex, so that they hold all that lies between corners that they hold.
 */
function overlapsAll({ box, inner }: Claim, { x, y, radius }: Circle, corners: readonly Point[], { to, off }: Aim): boolean {
  const inCircle = (p: Point) => apart(p, { x, y }) < radius + inner - ROUNDING;
  const inBox = (p: Point) => {
    const way = { x: x - p.x, y: y - p.y };
    const beyond = {
      x: Math.max(0, Math.abs(dot(way, to)) - box.halfWidth),
      y: Math.max(0, Math.abs(way.y * to.x - way.x * to.y) - box.halfHeight),
    };
    return apart(beyond, { x: 0, y: 0 }) + box.halfDiagonal * off < radius - ROUNDING;
  };
  return corners.every(inCircle) || corners.every(inBox);
}

/** Whether all of a bundle is out of range at the end of a step. */
function isLost({ asteroids, drift, seconds }: Scene, { atTimes }: Bundle, step: number): boolean {
  const [right, , high, , left, , low] = atTimes[step] as Octagon;
  const here: Area = { left: -left, right, low: -low, high };
  return asteroids.every((rock, i) => distances(rock, here).least > rock.radius + drift(i, step * seconds) + ROUNDING);
}

/** A bundle that holds two others. */
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

/** Half a turn of her box changes nothing. */
function eitherAim(a: Aim, b: Aim): Aim {
  const sign = dot(a.to, b.to) < 0 ? -1 : 1;
  const other = { x: sign * b.to.x, y: sign * b.to.y };
  const sum = { x: a.to.x + other.x, y: a.to.y + other.y };
  const size = apart(sum, { x: 0, y: 0 });
  const to = { x: sum.x / size, y: sum.y / size };
  return { to, off: Math.min(2, Math.max(apart(to, a.to) + a.off, apart(to, other) + b.off) + 1e-12) };
}

const dot = (a: Point, b: Point): number => a.x * b.x + a.y * b.y;
const middleOf = ({ left, right, low, high }: Area): Point => ({ x: (left + right) / 2, y: (low + high) / 2 });
const halfDiagonal = ({ left, right, low, high }: Area): number => apart({ x: left, y: low }, { x: right, y: high }) / 2;
const cornersOf = ({ left, right, low, high }: Area): Point[] => [left, right].flatMap((x) => [low, high].map((y) => ({ x, y })));

/** Distances from a place to the nearest and to the farthest place of an area. */
function distances(p: Point, area: Area): { least: number; most: number } {
  const beside = { x: Math.max(0, area.left - p.x, p.x - area.right), y: Math.max(0, area.low - p.y, p.y - area.high) };
  return { least: apart(beside, { x: 0, y: 0 }), most: Math.max(...cornersOf(area).map((corner) => apart(corner, p))) };
}

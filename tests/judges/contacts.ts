import {
  ACCURACIES,
  type Accuracy,
  accuracyOf,
  compile,
  DEFAULT_BOX,
  type Run,
  STATE_SIZE,
  simulate,
  TICK,
} from '../../engine/index.ts';
import { type Asteroid, type Circle, type Hold, type Level, NO_OBJECTS } from '../../schema/index.ts';
import { seeded } from '../scenes/seeded.ts';

/** Objects with a guard of their own, which she is made to touch or miss by very little. */
const KINDS = [
  'nova',
  'nova',
  'nova',
  'black hole',
  'mineral',
  'repulsor',
  'alien wakes',
  'target',
  'alien',
  'two aliens',
  'hot rock',
  'wind',
  'mouth',
] as const;
export type GrazedKind = (typeof KINDS)[number];

/**
 * Accuracies at which the path can be read exactly as the guards see it: error control, tight and loose, and a fixed step.
 * (With Verlet and Runge-Kutta, the displayed places differ from the polynomial by the error of a step.)
 */
export const GRAZED_AT: readonly Accuracy[] = [
  ACCURACIES.precise,
  accuracyOf({ integrator: 'taylor', rate: null, tolerance: 1e-4, contact: 'swept' }),
  accuracyOf({ integrator: 'euler', rate: 60, tolerance: null, contact: 'swept' }),
];

const MOTIONS = [
  'coast',
  'orbit',
  'fall',
  'let go',
  'two asteroids',
  'recoil',
  'field',
  'fast',
  'close pass',
  'wind',
  'wormhole',
] as const;

/** A run that grazes one object. The same run without that object gives the truth. */
export interface Graze {
  readonly level: Level;
  readonly holds: readonly Hold[];
  readonly accuracy: Accuracy;
  readonly kind: GrazedKind;
  readonly motion: (typeof MOTIONS)[number];
  /** Radius, px; Infinity for the line between two asteroids. */
  readonly radius: number;
  /** How deep she dips in, px; negative for a distance by which she misses. */
  readonly depth: number;
  /** End of the examined time, s. */
  readonly until: number;
  /** When she should be nearest, s. */
  readonly nearest: number;
  /** The gap at a time, from the run without the object, px. */
  gap(time: number): number;
  /** Rounding error of `gap`, px. */
  readonly rounding: number;
}

interface Path {
  readonly level: Level;
  readonly holds: readonly Hold[];
  readonly run: Run;
  readonly until: number;
}

/** How far away the grazed mouth leads, px on both axes. */
const AWAY = 5e6;

const FAR: Circle = { id: null, x: 1e7, y: 1e7, radius: 18 };
const rock = (x: number, y: number): Asteroid => ({ id: null, x, y, radius: 16, hot: false });

/**
 * Makes a graze from a seed, or null if the seed gives none. A run is simulated, and a moment of it and a point of the box (of
 * her centre, for rims) are chosen. A circle is placed whose edge the point passes, nearest at that moment.
 */
export function graze(seed: number, accuracy: Accuracy): Graze | null {
  const random = seeded(seed);
  const between = (a: number, b: number) => a + (b - a) * random();
  const pick = <T>(from: readonly T[]): T => from[Math.floor(random() * from.length)];
  const kind = pick(KINDS);
  const motion = pick(MOTIONS);
  const path = fly(motion, kind, accuracy, between);
  if (path === null) return null;
  if (kind === 'alien' || kind === 'two aliens' || kind === 'hot rock') {
    const wanted = pick([-1, 1]) * 10 ** between(-9, 0);
    const moving = amongMoving(path, kind, accuracy, wanted, between);
    return moving === null ? null : { ...moving, holds: path.holds, accuracy, kind, motion, depth: wanted, rounding: 2e-11 };
  }
  const { run, until } = path;
  const state = new Float64Array(STATE_SIZE);
  // offset of a point of the box from her centre, along the world's axes
  const pointAt = (time: number, [bx, by]: readonly [number, number]): [number, number] => {
    run.trajectory.at(time, state);
    const [x, y, , , cos, sin] = state;
    return [x + bx * cos - by * sin, y + bx * sin + by * cos];
  };
  const nearest = between(0.02, 0.98) * until;
  const step = 1e-4 * Math.min(1, until);
  if (run.events.some(({ time }) => Math.abs(time - nearest) < 2 * step)) return null;
  const byCentre = kind === 'repulsor' || kind === 'alien wakes' || kind === 'target' || kind === 'wind' || kind === 'mouth';
  const point: readonly [number, number] = byCentre
    ? [0, 0]
    : [pick([-1, 1]) * DEFAULT_BOX.halfWidth, pick([-1, 1]) * DEFAULT_BOX.halfHeight];
  const [ax, ay] = pointAt(nearest - step, point);
  const [x, y] = pointAt(nearest, point);
  const [bx, by] = pointAt(nearest + step, point);
  const way = Math.hypot(bx - ax, by - ay);
  if (!(way > 1e-9 * step)) return null;
  const side = pick([-1, 1]);
  const nx = (side * (ay - by)) / way;
  const ny = (side * (bx - ax)) / way;
  if (!byCentre) {
    // the corner is the foremost one towards the circle
    run.trajectory.at(nearest, state);
    const [, , , , cos, sin] = state;
    if ((nx * cos + ny * sin) * point[0] < 0 || (ny * cos - nx * sin) * point[1] < 0) return null;
  }
  // 1e-3 to 1e6 px, 1e-9 to 1 px; more of the large and thin ones, which are the hardest
  const any = 10 ** between(pick([-3, 4]), 6);
  const radius = kind === 'alien wakes' ? 150 : kind === 'target' ? Number.POSITIVE_INFINITY : any;
  const depth = pick([-1, 1]) * Math.min(10 ** between(-9, pick([-5, 0])), radius / 4);
  const { level, gap } = withThing(path, kind, radius, depth, x, y, nx, ny, random());
  // the line between two asteroids close to each other is not known to many digits
  const [first, other] = level.asteroids;
  const size = kind === 'target' ? 1e3 + 1e5 / Math.hypot(other.x - first.x, other.y - first.y) : radius;
  return {
    level,
    holds: path.holds,
    accuracy,
    kind,
    motion,
    radius,
    depth,
    until,
    nearest,
    // at 1e6 px this is the promised 1e-9 px
    rounding: 2e-11 + 1e-15 * size,
    gap(time) {
      run.trajectory.at(time, state);
      return gap(state);
    },
  };
}

/** Distance of a point from her box, px; 0 within it. */
function fromBox([px, py, , , cos, sin]: Float64Array, x: number, y: number): number {
  const [dx, dy] = [x - px, y - py];
  const gx = Math.max(0, Math.abs(dx * cos + dy * sin) - DEFAULT_BOX.halfWidth);
  const gy = Math.max(0, Math.abs(dy * cos - dx * sin) - DEFAULT_BOX.halfHeight);
  return Math.hypot(gx, gy);
}

/**
 * Makes a graze of a moving object. Its path does not depend on whether it is deadly or large, so the run without these gives
 * the truth: the least distance in that run is found, and the radius is chosen such that it reaches as far and by `depth`
 * farther.
 */
function amongMoving(
  { level, holds, until }: Path,
  kind: 'alien' | 'two aliens' | 'hot rock',
  accuracy: Accuracy,
  depth: number,
  between: (a: number, b: number) => number,
): Pick<Graze, 'level' | 'radius' | 'until' | 'nearest' | 'gap'> | null {
  const { x, y } = level.astronaut;
  const place = (far: number) => ({ id: null, x: x + between(-far, far), y: y + between(-far, far) });
  const places = kind === 'hot rock' ? [place(250)] : [place(120), place(120)];
  const make = (r: number, truth: boolean): Level => {
    if (kind === 'hot rock') {
      // recoil depends on the radius, so the asteroid has the same one in both runs
      return { ...level, recoil: true, asteroids: [...level.asteroids, { ...places[0], radius: r, hot: !truth }] };
    }
    const radius = truth ? 1e-3 : r;
    return { ...level, aliens: (kind === 'alien' ? places.slice(0, 1) : places).map((o) => ({ ...o, radius })) };
  };
  const state = new Float64Array(STATE_SIZE);
  const aliens = new Float64Array(6);
  const rocks = new Float64Array(2 * level.asteroids.length + 2);
  let radius = 16;
  for (let round = 0; ; round++) {
    const run = simulate(compile(make(radius, true), accuracy), holds, { maxTime: until });
    const end = Math.min(until, run.time) - 1e-6;
    if (end < 0.05) return null;
    const distance = (time: number): number => {
      if (kind === 'two aliens') {
        run.trajectory.aliensAt(time, aliens);
        return Math.hypot(aliens[3] - aliens[0], aliens[4] - aliens[1]) / 2;
      }
      run.trajectory.at(time, state);
      if (kind === 'alien') {
        run.trajectory.aliensAt(time, aliens);
        return fromBox(state, aliens[0], aliens[1]);
      }
      run.trajectory.asteroidsAt(time, rocks);
      return fromBox(state, rocks[rocks.length - 2], rocks[rocks.length - 1]);
    };
    let nearest = 0;
    for (let i = 1; i <= 600; i++) if (distance((end * i) / 600) < distance(nearest)) nearest = (end * i) / 600;
    for (let h = end / 1200; h > 1e-9; h /= 2) {
      for (const t of [nearest - h, nearest + h]) if (t >= 0 && t <= end && distance(t) < distance(nearest)) nearest = t;
    }
    const found = distance(nearest) + depth;
    if (!(found > 0.01)) return null;
    if (kind === 'hot rock' && Math.abs(found - radius) > 1e-10 && round < 12) {
      radius = found;
      continue;
    }
    const reach = kind === 'hot rock' ? radius : found;
    return { level: make(reach, false), radius: reach, until: end, nearest, gap: (time) => distance(time) - reach };
  }
}

/** The level with the object in it, and a function that gives the gap to it in a state. */
function withThing(
  { level }: Path,
  kind: GrazedKind,
  radius: number,
  depth: number,
  x: number,
  y: number,
  nx: number,
  ny: number,
  share: number,
): { level: Level; gap: (state: Float64Array) => number } {
  if (kind === 'target') {
    // the first asteroid mirrored in the line along which she passes
    const first = level.asteroids[0];
    const to = (x - first.x) * nx + (y - first.y) * ny - depth;
    const other = rock(first.x + 2 * to * nx, first.y + 2 * to * ny);
    const [mx, my] = [other.x - first.x, other.y - first.y];
    const apart = Math.hypot(mx, my);
    return {
      level: { ...level, asteroids: [...level.asteroids, other] },
      gap: ([px, py]) => (mx * (first.x + other.x - 2 * px) + my * (first.y + other.y - 2 * py)) / (2 * apart),
    };
  }
  const circle: Circle = { id: null, x: x + (radius - depth) * nx, y: y + (radius - depth) * ny, radius };
  const byCentre = ([px, py]: Float64Array) => Math.hypot(circle.x - px, circle.y - py) - radius;
  if (kind === 'repulsor') return { level: { ...level, repulsors: [...level.repulsors, circle] }, gap: byCentre };
  // what the object does once she is in it must not change the truth: a wind without force, and a mouth that leads far away
  if (kind === 'wind') return { level: { ...level, winds: [...level.winds, { ...circle, ax: 0, ay: 0 }] }, gap: byCentre };
  if (kind === 'mouth') {
    return { level: { ...level, wormholes: [...level.wormholes, { ...circle, toX: AWAY, toY: AWAY }] }, gap: byCentre };
  }
  // an alien touches her only when she is almost on top of it
  if (kind === 'alien wakes') {
    return { level: { ...level, aliens: [{ ...circle, radius: 1 + 9 * share }] }, gap: byCentre };
  }
  const byBox = (state: Float64Array) => fromBox(state, circle.x, circle.y) - radius;
  if (kind === 'nova') return { level: { ...level, novae: [circle] }, gap: byBox };
  if (kind === 'mineral') return { level: { ...level, minerals: [circle] }, gap: byBox };
  return { level: { ...level, blackHole: circle }, gap: byBox };
}

function fly(
  motion: Graze['motion'],
  kind: GrazedKind,
  accuracy: Accuracy,
  between: (a: number, b: number) => number,
): Path | null {
  const seconds = between(0.3, 6);
  const ticks = Math.ceil(seconds * 60);
  const away = between(50, 220);
  const turn = between(0, 2 * Math.PI);
  let speed = between(0, 80);
  let heading = between(0, 2 * Math.PI);
  const asteroids = [rock(0, 0)];
  let holds: Hold[] = [[0, ticks]];
  let range = 250;
  if (motion === 'coast') holds = [];
  if (motion === 'fall') speed = 0;
  if (motion === 'let go') holds = [[0, Math.ceil(between(1, 60))]];
  if (motion === 'two asteroids') asteroids.push(rock(between(-200, 200), between(-200, 200)));
  if (motion === 'fast') {
    speed = between(900, 1000);
    range = 1e6;
  }
  if (motion === 'close pass') {
    speed = between(20, 80);
    heading = turn + Math.PI + 10 ** between(-5, -1);
  }
  // a mouth does not fire if another wormhole has put her into it
  if (kind === 'mouth' && motion === 'wormhole') return null;
  // the border between two asteroids is a line only if they stand still and are the only ones
  if (kind === 'target' && (motion === 'two asteroids' || motion === 'coast' || motion === 'recoil')) return null;
  const field: Circle = { id: null, x: between(-150, 150), y: between(-150, 150), radius: between(30, 150) };
  const [x, y] = [away * Math.cos(turn), away * Math.sin(turn)];
  const level: Level = {
    name: 'graze',
    description: '',
    astronaut: { x, y, vx: speed * Math.cos(heading), vy: speed * Math.sin(heading) },
    blackHole: FAR,
    range: Math.max(range, away + 10),
    recoil: motion === 'recoil',
    ...NO_OBJECTS,
    asteroids,
    repulsors: motion === 'field' ? [field] : [],
    winds: motion === 'wind' ? [{ ...field, ax: between(-60, 60), ay: between(-60, 60) }] : [],
    wormholes: motion === 'wormhole' ? [{ ...field, toX: between(-150, 150), toY: between(-150, 150) }] : [],
    runs: [],
  };
  const run = simulate(compile(level, accuracy), holds, { maxTime: seconds });
  const until = Math.min(run.time, seconds) - 1e-6;
  return until > 0.05 ? { level, holds, run, until } : null;
}

/**
 * First time in [0, until] at which `gap` is below -`margin`: by dense samples and golden-section search in every dip between
 * them.
 */
function firstDip(g: Graze, margin: number): number | null {
  const times: number[] = [];
  const SAMPLES = 600;
  for (let i = 0; i <= SAMPLES; i++) times.push((g.until * i) / SAMPLES);
  // ever more densely around the chosen moment
  for (let d = g.until / SAMPLES; d > 1e-9; d /= 4) times.push(g.nearest - d, g.nearest + d);
  times.push(g.nearest);
  const sorted = times.filter((t) => t >= 0 && t <= g.until).sort((a, b) => a - b);
  const gaps = sorted.map((t) => g.gap(t) + margin);
  for (let i = 0; i < sorted.length; i++) {
    if (gaps[i] < 0) return i === 0 ? 0 : crossing(g, margin, sorted[i - 1], sorted[i]);
    if (i === 0 || i === sorted.length - 1 || gaps[i] > gaps[i - 1] || gaps[i] > gaps[i + 1]) continue;
    // golden section
    const share = (3 - Math.sqrt(5)) / 2;
    let [a, b] = [sorted[i - 1], sorted[i + 1]];
    for (let n = 0; n < 60 && b - a > 1e-12; n++) {
      const [c, d] = [a + share * (b - a), b - share * (b - a)];
      const [gc, gd] = [g.gap(c) + margin, g.gap(d) + margin];
      if (Math.min(gc, gd) < 0) return crossing(g, margin, sorted[i - 1], gc < gd ? c : d);
      if (gc < gd) b = d;
      else a = c;
    }
  }
  return null;
}

function crossing(g: Graze, margin: number, before: number, behind: number): number {
  let [a, b] = [before, behind];
  for (let n = 0; n < 60; n++) {
    const middle = (a + b) / 2;
    if (g.gap(middle) + margin < 0) b = middle;
    else a = middle;
  }
  return b;
}

/** When the engine lets her touch the object first, s. */
function engineTime(g: Graze): number | null {
  const run = simulate(compile(g.level, g.accuracy), g.holds, { maxTime: g.until + TICK });
  if (g.kind === 'nova' || g.kind === 'alien' || g.kind === 'hot rock') return run.outcome === 'collided' ? run.time : null;
  if (g.kind === 'black hole') return run.outcome === 'completed' ? run.time : null;
  const field = g.level.repulsors.length - 1;
  const other = g.level.asteroids.length - 1;
  const wind = g.level.winds.length - 1;
  const wormhole = g.level.wormholes.length - 1;
  // an alien that is large enough to touch the other one may touch her first
  if (g.kind === 'two aliens' && run.outcome === 'collided') return 0;
  const event = run.events.find(
    (e) =>
      (g.kind === 'two aliens' && e.type === 'explosion') ||
      (g.kind === 'mineral' && e.type === 'mineral') ||
      (g.kind === 'repulsor' && e.type === 'enter' && e.index === field) ||
      (g.kind === 'alien wakes' && e.type === 'wake') ||
      (g.kind === 'wind' && e.type === 'effect' && e.effect === 'winds' && e.what === 'enter' && e.index === wind) ||
      (g.kind === 'mouth' && e.type === 'effect' && e.effect === 'wormholes' && e.index === wormhole) ||
      (g.kind === 'target' && e.type === 'target' && e.index === other),
  );
  return event?.time ?? null;
}

/** The result of examining a graze. `hit` and `missed` agree with the truth; `vague`: she is in the object from the start. */
export type GrazeFinding = { readonly what: 'hit' | 'missed' | 'vague' } | { readonly what: 'bug'; readonly why: string };

/** Compares the engine with the truth about a graze. */
export function checkGraze(g: Graze): GrazeFinding {
  // inside it at the start, or on top of another object as the run begins
  if (g.gap(0) < 1e-6) return { what: 'vague' };
  const bug = (why: string): GrazeFinding => ({
    what: 'bug',
    why: `${g.accuracy.name}, ${g.motion}, ${g.kind} of ${g.radius} px, ${g.depth} px deep at ${g.nearest} s: ${why}`,
  });
  const found = engineTime(g);
  // the box as it is before a press turns it
  if (found === 0) return { what: 'vague' };
  const sure = firstDip(g, g.rounding);
  if (found === null || found > g.until)
    return sure === null ? { what: 'missed' } : bug(`missed, though touched from ${sure} s on`);
  if (sure !== null && found > sure + 1e-9) return bug(`found at ${found} s, though touched from ${sure} s on`);
  // a corner of a box that turns fast moves by more than rounding between two adjacent doubles of time
  const gap = Math.min(g.gap(found), g.gap(found + Number.EPSILON * (1 + found)));
  if (gap > g.rounding) return bug(`found at ${found} s, where the gap is ${gap} px`);
  return { what: 'hit' };
}

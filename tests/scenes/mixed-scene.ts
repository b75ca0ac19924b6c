import { type Hold, type Level, type OwnRules, RULES, type RuleName, rulesOf } from '../../schema/index.ts';
import { type RandomScene, randomHolds } from './random-scene.ts';
import { seeded } from './seeded.ts';

/** Directions of length 1 whose coordinates are exact, or multiples of 1/5 for lengths that 5 divides. */
const EXACT_DIRECTIONS: readonly (readonly [number, number])[] = [
  ...([
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ] as const),
  ...([
    [0.6, 0.8],
    [-0.8, 0.6],
    [0.8, -0.6],
    [-0.6, -0.8],
  ] as const),
];

type Disc = { readonly x: number; readonly y: number; readonly radius: number };

/**
 * Makes a scene from a seed in which all effects meet: each kind of object and each rule is there with even odds, numbers are
 * drawn over their whole range, most of them evenly by their logarithm; speed limits are mostly low. Objects share centres,
 * stand on rims of others, mouths share exits and are in each other. A third of the scenes begins with what is exact in
 * doubles: touches, places on rims, equal distances, mirror images.
 */
export function mixedScene(seed: number): RandomScene {
  const draw = new Draw(seed);
  const { chance, pick } = draw;
  const isExact = chance(0.35);
  const rules = drawRules(draw, isExact);
  const of = rulesOf({ rules });
  const quantum = isExact ? pick(1, 1, 5, 10) : pick(0, 0, 0, 1, 20);
  const spread = pick(80, 150, 250, 400, 700);
  const [originX, originY] = chance(0.06) ? [pick(2 ** 20, -(2 ** 27), 1e6), pick(0, 2 ** 20)] : [0, 0];
  const snap = (v: number) => (quantum > 0 ? Math.round(v / quantum) * quantum : v);
  const others: Disc[] = [];

  const radius = (...usual: number[]) => {
    if (isExact) return pick(...usual, 5, 10, 25, 50);
    if (chance(0.55)) return pick(...usual);
    return chance(0.85) ? draw.log(0.2, 400) : draw.log(0.001, 1e6);
  };
  /** A place of its own, or one that has to do with another disc or with her start. */
  const place = (r: number): { x: number; y: number } => {
    if (others.length > 0 && chance(0.3)) {
      const other = pick(...others);
      const [dx, dy] = pick(...EXACT_DIRECTIONS);
      const far = pick(0, 0, other.radius, other.radius + r, Math.abs(other.radius - r));
      return { x: other.x + dx * far, y: other.y + dy * far };
    }
    const near = { x: originX + snap(draw.between(-spread, spread)), y: originY + snap(draw.between(-spread, spread)) };
    if (r <= spread) return near;
    // of a disc that is larger than all the rest its rim is near
    const [dx, dy] = pick(...EXACT_DIRECTIONS);
    return { x: near.x + dx * r, y: near.y + dy * r };
  };
  const disc = (r: number): Disc => {
    const made = { ...place(r), radius: r };
    others.push(made);
    return made;
  };
  /** A disc that does not cover her start: a hazard there would leave nothing to examine. */
  const away = (r: number): Disc => {
    const reach = r + (of.boxWidth + of.boxHeight) / 2 + 5;
    let made = { ...place(r), radius: r };
    for (let n = 0; n < 8 && Math.hypot(made.x - originX, made.y - originY) < reach; n++) made = { ...place(r), radius: r };
    if (Math.hypot(made.x - originX, made.y - originY) < reach) made = { ...made, x: originX + pick(1, -1) * Math.ceil(reach) };
    others.push(made);
    return made;
  };
  /** A disc on whose rim she starts, exactly. */
  const aroundStart = (r: number): Disc => {
    const [dx, dy] = pick(...EXACT_DIRECTIONS.slice(0, r % 5 === 0 ? 8 : 4));
    return { x: originX + dx * r, y: originY + dy * r, radius: r };
  };
  const field = (r: number): Disc => (isExact && chance(0.3) ? aroundStart(r) : disc(r));
  const list = <T>(most: number, make: () => T): T[] => (chance(0.5) ? [] : Array.from({ length: 1 + draw.int(most - 1) }, make));
  const withId = <T>(object: T) => ({ id: null, ...object });

  const range = chance(0.7) ? pick(250, 300, 400, 600) : snap(chance(0.8) ? draw.log(60, 5000) : draw.log(0.001, 1e6)) || 100;
  const first = Math.min(0.7 * range, spread);
  const asteroids = Array.from({ length: 1 + draw.int(pick(0, 1, 2, 4)) }, (_, i) => {
    const hot = chance(0.2);
    const r = radius(16, 32);
    if (i === 0 && !chance(0.1)) {
      const nearby = {
        x: originX + snap(draw.between(-first, first)),
        y: originY + snap(draw.between(-first, first)),
        radius: r,
      };
      others.push(nearby);
      return withId({ ...nearby, hot: false });
    }
    return withId({ ...(hot ? away(r) : disc(r)), hot });
  });
  // a twin at the same distance: her mirror image, or the same turned by a right angle
  if (isExact && chance(0.4)) {
    const { x, y, radius: r } = asteroids[0];
    const [dx, dy] = [x - originX, y - originY];
    const [tx, ty] = pick([-dx, dy], [dx, -dy], [-dx, -dy], [dy, dx]);
    asteroids.push(withId({ x: originX + tx, y: originY + ty, radius: r, hot: false }));
  }
  const repulsors = list(3, () => withId(field(radius(32, 48, 100))));
  const strength = () => (isExact ? pick(0, 5, -20, 20, 40, -100) : pick(0, draw.between(-40, 40), draw.between(-100, 100)));
  const winds = list(3, () => withId({ ...field(radius(60, 120, 400)), ax: strength(), ay: strength() }));
  const wormholes = list(3, () => {
    const r = radius(8, 24, 60);
    const entry = chance(0.4) ? inHerWay(r) : place(r);
    const exits = others.slice(-3);
    const exit = exits.length > 0 && chance(0.3) ? pick(...exits) : place(r);
    others.push({ ...entry, radius: r }, { ...exit, radius: r });
    return withId({ x: entry.x, y: entry.y, toX: exit.x, toY: exit.y, radius: r });
  });
  const touching = (r: number): Disc => touchStart(draw, r, of.boxWidth, of.boxHeight, originX, originY);
  const hazard = (r: number): Disc => (isExact && chance(0.3) ? touching(r) : away(r));
  const alien = (r: number): Disc => {
    if (isExact && chance(0.2)) return touching(r);
    return isExact && chance(0.2) && of.alienSight > 60 ? { ...aroundStart(of.alienSight), radius: r } : away(r);
  };
  const holeRadius = radius(18);
  const start = startVelocity();
  const level: Level = {
    name: `mixed scene ${seed}`,
    description: '',
    astronaut: { x: originX, y: originY, ...start },
    blackHole: chance(0.2) ? hazard(holeRadius) : away(holeRadius),
    range,
    recoil: chance(0.5),
    asteroids,
    novae: list(3, () => withId(hazard(radius(16, 32)))),
    repulsors,
    aliens: list(4, () => withId(alien(radius(25)))),
    minerals: list(4, () => withId(disc(radius(7)))),
    winds,
    wormholes,
    ...(Object.keys(rules).length === 0 ? {} : { rules }),
    runs: [],
  };
  const maxTime = pick(2, 4, 4, 8, 8, 20);
  return { level, holds: holdsOf(draw, maxTime * 60), maxTime };

  function startVelocity(): { vx: number; vy: number } {
    if (chance(0.35)) return { vx: 0, vy: 0 };
    const speed = Math.min(1000, pick(draw.log(1, 1000), draw.log(5, 100), of.speedLimit, of.speedLimit / 2));
    if (isExact || chance(0.2)) {
      const whole = isExact ? Math.max(5, Math.round(speed / 5) * 5) : speed;
      const [dx, dy] = pick(...EXACT_DIRECTIONS);
      return { vx: dx * whole, vy: dy * whole };
    }
    return { vx: draw.between(-speed, speed), vy: draw.between(-speed, speed) };
  }

  /** A place that she may reach soon. */
  function inHerWay(r: number): { x: number; y: number } {
    const far = r + draw.log(5, 150);
    const [dx, dy] = pick(...EXACT_DIRECTIONS);
    return { x: originX + snap(dx * far), y: originY + snap(dy * far) };
  }
}

/** A disc that touches her box at the start, exactly: a side of it, or a corner. */
function touchStart({ pick, chance }: Draw, radius: number, width: number, height: number, x: number, y: number): Disc {
  const [hw, hh] = [width / 2, height / 2];
  const along = pick(0, 0, 1, 3, -2);
  if (chance(0.3) && radius % 5 === 0) {
    const [dx, dy] = pick([0.6, 0.8], [0.8, 0.6]);
    return { x: x + pick(1, -1) * (hw + dx * radius), y: y + pick(1, -1) * (hh + dy * radius), radius };
  }
  if (chance(0.5)) return { x: x + pick(1, -1) * (hw + radius), y: y + Math.min(along, hh), radius };
  return { x: x + Math.min(along, hw), y: y + pick(1, -1) * (hh + radius), radius };
}

/** Each rule is the game's own or drawn over its range. */
function drawRules(draw: Draw, isExact: boolean): OwnRules {
  const rules: Partial<Record<RuleName, number>> = {};
  if (draw.chance(0.25)) return rules;
  for (const name of Object.keys(RULES) as RuleName[]) {
    if (!draw.chance(0.4)) continue;
    const { least, most } = RULES[name];
    // a speed limit near 1000 is never reached
    const [low, high] = name === 'speedLimit' ? [least, draw.pick(40, 100, most)] : [least === 0 ? most / 1e4 : least, most];
    const value = least === 0 && draw.chance(0.1) ? 0 : draw.log(low, high);
    const step = name === 'boxWidth' || name === 'boxHeight' ? 2 : 1;
    rules[name] = isExact ? Math.max(least, Math.min(most, Math.round(value / step) * step || step)) : value;
  }
  return rules;
}

/** A script as people press, a single hold all along, or none. */
function holdsOf(draw: Draw, lastTick: number): Hold[] {
  if (draw.chance(0.3)) return [[0, lastTick]];
  if (draw.chance(0.05)) return [];
  return randomHolds(draw.random, lastTick);
}

/** Draws numbers from a seed. */
class Draw {
  readonly random: () => number;

  constructor(seed: number) {
    this.random = seeded(seed ^ 0x51ce9e);
  }

  readonly int = (most: number): number => Math.floor(this.random() * (most + 1));
  readonly chance = (p: number): boolean => this.random() < p;
  readonly between = (a: number, b: number): number => a + (b - a) * this.random();
  /** Even by its logarithm. Six digits are the same whatever the last one of a power is. */
  readonly log = (a: number, b: number): number => Number(Math.min(b, a * (b / a) ** this.random()).toPrecision(6));
  readonly pick = <T>(...of: T[]): T => of[this.int(of.length - 1)];
}

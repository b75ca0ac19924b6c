import {
  add,
  compare,
  type Dd,
  dd,
  divide,
  dot,
  minus,
  multiply,
  roughLength,
  subtract,
  times,
  toNumber,
  ZERO,
} from '../double-double.ts';
import { CLOSE, EXACT, gapBetween, type Happening, type Kind, type Margins, spend } from '../stretch.ts';
import { type Mover, placeOf, secondMouth, type World } from '../world.ts';
import type { Moment, Motion } from './motion.ts';

/** Moments of a stretch at which every guard is looked at; what lies between two of them is found by its slopes. */
const INTERVALS = 32;

/** A guard below this share of its size is 0: 24 of 32 digits agree, and only an exact tie does that. */
const NOTHING = 1e-24;

/** How often a stretch is halved to see what a guard does right after it was 0 at its start. */
const OPENINGS = 44;
const SMALLEST_OPENING = 1 / 17_592_186_044_416; // 2^-44

/** What happens when a function of the state falls below 0. */
interface Guard {
  readonly kind: Kind;
  readonly index: number;
  readonly other: number;
  readonly value: (moment: Moment) => Dd;
  /** Natural size of the numbers that the value is a difference of. */
  readonly size: number;
  /** Change of the value per px, where its least values are narrow misses; else 0. */
  readonly slope: number;
}

/**
 * Brackets what happens first: values at moments of the stretch, minima between them by golden sections, and roots by the
 * Illinois method. Nothing of it knows that motion is polynomial.
 */
export class Bracketing {
  readonly #motion: Motion;
  readonly #end: Dd;
  readonly #margins: Margins;
  readonly #grid: readonly { readonly time: Dd; readonly moment: Moment }[];

  /** @param end - until when, s from the start of the stretch */
  constructor(motion: Motion, end: Dd, margins: Margins) {
    this.#motion = motion;
    this.#end = end;
    this.#margins = margins;
    this.#grid = Array.from({ length: INTERVALS + 1 }, (_, m) => {
      const time = m === INTERVALS ? end : times(end, m / INTERVALS);
      return { time, moment: motion.at(time) };
    });
  }

  find(world: World): Happening[] {
    if (!(this.#end.hi > 0)) return [];
    const found: Happening[] = [];
    for (const guard of guardsOf(world, this.#motion, (of) => this.#travel(world, of))) {
      spend(world, INTERVALS);
      const at = this.#first(guard);
      if (at !== null) found.push({ at, kind: guard.kind, index: guard.index, other: guard.other });
    }
    if (found.length === 0) return found;
    const first = Math.min(...found.map(({ at }) => toNumber(at)));
    return found.filter(({ at }) => toNumber(at) <= first + CLOSE);
  }

  /** The most that something departs from where it starts, px. */
  #travel(world: World, of: Of): number {
    spend(world, INTERVALS / 8);
    const start = of(this.#grid[0].moment).at;
    let most = 0;
    for (const { moment } of this.#grid) {
      const { at } = of(moment);
      most = Math.max(most, roughLength(at.x.hi - start.x.hi, at.y.hi - start.y.hi));
    }
    return 1.2 * most + 1e-9;
  }

  /** The first time at which a guard is below 0. */
  #first({ value, size, slope }: Guard): Dd | null {
    const values = this.#grid.map(({ moment }) => value(moment));
    const whole = size + Math.max(...values.map(({ hi }) => Math.abs(hi - values[0].hi)));
    const sign = ({ hi }: Dd): number => (Math.abs(hi) <= NOTHING * whole ? 0 : Math.sign(hi));
    const of = (time: Dd): Dd => value(this.#motion.at(time));
    if (sign(values[0]) < 0) return ZERO;
    let opening = ZERO;
    if (sign(values[0]) === 0) {
      // what is 0 at the start has the sign that it has right after it
      let opened = 0;
      for (let n = 0; opened === 0 && n < OPENINGS; n++) {
        opening = n === 0 ? times(this.#end, SMALLEST_OPENING) : times(opening, 2);
        opened = sign(of(opening));
      }
      if (opened < 0) return ZERO;
    }
    const timeOf = (m: number): Dd => (m === 0 ? opening : this.#grid[m].time);
    for (let m = 0; m <= INTERVALS; m++) {
      const time = timeOf(m);
      if (m > 0 && sign(values[m]) < 0) return root(of, timeOf(m - 1), time);
      const left = m === 0 ? m : m - 1;
      const right = m === INTERVALS ? m : m + 1;
      const here = values[m].hi;
      if (sign(values[m]) < 0 || here > values[left].hi || here > values[right].hi) continue;
      const rise = Math.max(values[left].hi - here, values[right].hi - here);
      if (rise <= NOTHING * whole || here > 2 * rise) continue;
      const lowest = minimum(of, timeOf(left), timeOf(right));
      const least = of(lowest);
      if (sign(least) < 0) return root(of, compare(lowest, time) < 0 ? timeOf(left) : time, lowest);
      if (slope > 0) this.#missed(toNumber(least) / slope);
    }
    return null;
  }

  #missed(margin: number): void {
    if (margin < EXACT) this.#margins.exact++;
    else this.#margins.narrowest = Math.min(this.#margins.narrowest, margin);
  }
}

/** Where a function that is not below 0 at `from` and below 0 at `to` becomes so, by the Illinois method. */
function root(of: (time: Dd) => Dd, from: Dd, to: Dd): Dd {
  let low = from;
  let high = to;
  let a = of(low);
  let b = of(high);
  if (a.hi <= 0) return low;
  let side = 0;
  for (let n = 0; n < 200; n++) {
    const width = subtract(high, low);
    if (width.hi <= 1e-31 * Math.max(1e-6, high.hi)) break;
    // false position, where it does not creep; else the middle
    const share = divide(a, subtract(a, b));
    let at = add(low, multiply(width, share));
    if (n % 4 === 3 || !(compare(at, low) > 0 && compare(at, high) < 0)) at = add(low, times(width, 0.5));
    if (!(compare(at, low) > 0 && compare(at, high) < 0)) break;
    const value = of(at);
    if (value.hi === 0) return at;
    if (value.hi > 0) {
      low = at;
      a = value;
      if (side === 1) b = times(b, 0.5);
      side = 1;
    } else {
      high = at;
      b = value;
      if (side === -1) a = times(a, 0.5);
      side = -1;
    }
  }
  return high;
}

const GOLDEN = (Math.sqrt(5) - 1) / 2;

/** Where a function is least between two times, by golden sections: to half of the digits, where it is flat. */
function minimum(of: (time: Dd) => Dd, from: Dd, to: Dd): Dd {
  const width = toNumber(subtract(to, from));
  const at = (share: number): Dd => add(from, dd(width * share));
  let low = 0;
  let high = 1;
  let left = high - GOLDEN;
  let right = low + GOLDEN;
  let a = of(at(left));
  let b = of(at(right));
  while (high - low > 1e-15) {
    if (compare(a, b) < 0) {
      high = right;
      right = left;
      b = a;
      left = high - GOLDEN * (high - low);
      a = of(at(left));
    } else {
      low = left;
      left = right;
      a = b;
      right = low + GOLDEN * (high - low);
      b = of(at(right));
    }
    // below 0 is low enough
    if (a.hi < 0) return at(left);
    if (b.hi < 0) return at(right);
  }
  return at((low + high) / 2);
}

/** A body, by name, so that what it travels is measured once. */
type Of = (moment: Moment) => Mover;

/** All that may happen in a stretch, without what is too far away. */
function* guardsOf(world: World, { acting, start }: Motion, travel: (of: Of) => number): Generator<Guard> {
  const { level, rules, aliens, asteroids, fields, winds, mouths, slide, taken, limits, target, held } = world;
  const hers = travel(({ her }) => her);
  const stands = (at: Mover['at']): Of => {
    const body = { at, velocity: { x: ZERO, y: ZERO } };
    return () => body;
  };
  const asteroidOf = asteroids.map(
    (_, i): Of =>
      ({ asteroid }) =>
        asteroid(i),
  );
  const alienOf = aliens.map(
    (_, i): Of =>
      ({ alien }) =>
        alien(i),
  );
  const from = (a: Of, b: Of): number => {
    const u = minus(a(start).at, b(start).at);
    return roughLength(u.x.hi, u.y.hi);
  };
  const ofHer: Of = ({ her }) => her;
  const squared = (a: Of, b: Of) => (moment: Moment) => {
    const u = minus(a(moment).at, b(moment).at);
    return dot(u, u);
  };

  const contacts: [Kind, number, Of, number][] = [
    ...level.novae.map((c, i): [Kind, number, Of, number] => ['nova', i, stands(placeOf(c)), c.radius]),
    ...level.asteroids.flatMap((c, i): [Kind, number, Of, number][] => (c.hot ? [['asteroid', i, asteroidOf[i], c.radius]] : [])),
    ...level.aliens.flatMap((c, i): [Kind, number, Of, number][] => (aliens[i].gone ? [] : [['alien', i, alienOf[i], c.radius]])),
    ['blackHole', 0, stands(placeOf(level.blackHole)), level.blackHole.radius],
    ...level.minerals.flatMap((c, i): [Kind, number, Of, number][] =>
      taken[i] ? [] : [['mineral', i, stands(placeOf(c)), c.radius]],
    ),
  ];
  const diagonal = roughLength(rules.boxWidth, rules.boxHeight) / 2;
  for (const [kind, index, of, radius] of contacts) {
    if (from(ofHer, of) - diagonal - radius > hers + travel(of)) continue;
    yield {
      kind,
      index,
      other: -1,
      value: (moment) => gapBetween({ at: moment.her.at, box: moment.box }, rules, of(moment).at, radius),
      size: radius + diagonal,
      slope: 1,
    };
  }

  const rims: [Kind, number, Of, number, boolean][] = [
    ...(world.anchor < 0
      ? []
      : [['range', 0, asteroidOf[world.anchor], level.range, true] as [Kind, number, Of, number, boolean]]),
    ...level.repulsors.flatMap((c, i): [Kind, number, Of, number, boolean][] =>
      slide?.kind === 'field' && slide.index === i ? [] : [['field', i, stands(placeOf(c)), c.radius, fields[i]]],
    ),
    ...level.winds.flatMap((c, i): [Kind, number, Of, number, boolean][] =>
      slide?.kind === 'wind' && slide.index === i ? [] : [['wind', i, stands(placeOf(c)), c.radius, winds[i]]],
    ),
    ...level.wormholes.flatMap((c, i): [Kind, number, Of, number, boolean][] => {
      const kind = mouths[i] === 0 ? 'jump' : 'mouth';
      return [
        ...(mouths[i] === 2
          ? []
          : [[kind, 2 * i, stands(placeOf(c)), c.radius, mouths[i] === 1] as [Kind, number, Of, number, boolean]]),
        ...(mouths[i] === 1
          ? []
          : [[kind, 2 * i + 1, stands(secondMouth(c)), c.radius, mouths[i] === 2] as [Kind, number, Of, number, boolean]]),
      ];
    }),
    ...aliens.flatMap((alien, i): [Kind, number, Of, number, boolean][] =>
      alien.gone ? [] : [['sight', i, alienOf[i], rules.alienSight, alien.awake]],
    ),
  ];
  for (const [kind, index, of, radius, isInside] of rims) {
    if (Math.abs(from(ofHer, of) - radius) > hers + travel(of)) continue;
    const r2 = multiply(dd(radius), dd(radius));
    const d2 = squared(ofHer, of);
    const value = (moment: Moment) => (isInside ? subtract(r2, d2(moment)) : subtract(d2(moment), r2));
    yield { kind, index, other: -1, value, size: 1e-2 * radius * radius, slope: 2 * radius };
  }

  for (let i = 0; i < aliens.length; i++) {
    for (let j = i + 1; j < aliens.length; j++) {
      if (aliens[i].gone || aliens[j].gone) continue;
      const reach = add(dd(level.aliens[i].radius), dd(level.aliens[j].radius));
      if (from(alienOf[i], alienOf[j]) - reach.hi > travel(alienOf[i]) + travel(alienOf[j])) continue;
      const d2 = squared(alienOf[i], alienOf[j]);
      const value = (moment: Moment) => subtract(d2(moment), multiply(reach, reach));
      yield { kind: 'explosion', index: i, other: j, value, size: reach.hi * reach.hi, slope: 2 * reach.hi };
    }
  }

  if (held && target >= 0) {
    const own = from(ofHer, asteroidOf[target]);
    const most = 2 * hers + travel(asteroidOf[target]);
    const to = squared(ofHer, asteroidOf[target]);
    for (const [index, of] of asteroidOf.entries()) {
      if (index === target || from(ofHer, of) - own > most + travel(of)) continue;
      const d2 = squared(ofHer, of);
      const value = (moment: Moment) => subtract(d2(moment), to(moment));
      yield { kind: 'target', index, other: -1, value, size: own * own, slope: Math.max(2 * from(of, asteroidOf[target]), 1e-9) };
    }
  }

  const { gun, field } = acting.lines;
  const centres: [typeof gun, Of | null][] = [
    [gun, acting.target === null ? null : asteroidOf[target]],
    [field, acting.outside.field === null ? null : stands(acting.outside.field.at)],
  ];
  let line = 0;
  for (const [along, of] of centres) {
    if (along === null || of === null || roughLength(along.x.hi, along.y.hi) < 0.5) continue;
    const value = (moment: Moment) => dot(minus(of(moment).at, moment.her.at), along);
    yield { kind: 'centre', index: line++, other: -1, value, size: 0, slope: 1 };
  }

  if (slide !== null) {
    yield { kind: 'slip', index: 0, other: -1, value: ({ share }) => share!, size: 1, slope: 1 };
    yield { kind: 'slip', index: 1, other: -1, value: ({ share }) => subtract(dd(1), share!), size: 1, slope: 1 };
  }
  for (const index of [0, 1] as const) {
    const speed = ({ her: { velocity } }: Moment) => (index === 0 ? velocity.x : velocity.y);
    const force = (moment: Moment) => (index === 0 ? moment.force.x : moment.force.y);
    const sign = limits[index];
    const guard = { kind: 'limit', index, other: -1, slope: 1 } as const;
    if (sign !== 0) yield { ...guard, value: (moment) => times(force(moment), sign), size: 0 };
    else {
      const size = rules.speedLimit;
      yield { ...guard, value: (moment) => subtract(dd(size), speed(moment)), size };
      yield { ...guard, value: (moment) => add(dd(size), speed(moment)), size };
    }
  }
}

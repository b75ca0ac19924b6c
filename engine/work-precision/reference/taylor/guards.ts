import {
  add,
  compare,
  type Dd,
  dd,
  divide,
  multiply,
  negate,
  roughLength,
  subtract,
  times,
  toNumber,
  type Vector,
  ZERO,
} from '../double-double.ts';
import { CLOSE, EXACT, type Happening, type Kind, type Margins, spend } from '../stretch.ts';
import { placeOf, secondMouth, type World } from '../world.ts';
import type { Flow } from './flow.ts';
import { type Path, standing } from './path.ts';
import { crossings, firstBelow, NOTHING, opened } from './roots.ts';
import { about, eachOf, product, type Series, valueAt } from './series.ts';

/** Finds what happens in a stretch. */
export class Guards {
  readonly found: Happening[] = [];
  readonly #world: World;
  readonly #flow: Flow;
  readonly #margins: Margins;
  readonly #travels = new Map<Path, number>();
  #end: Dd;
  readonly #whole: number;

  /** @param end - up to which value of the flow's variable */
  constructor(world: World, flow: Flow, end: Dd, margins: Margins) {
    this.#world = world;
    this.#flow = flow;
    this.#margins = margins;
    this.#end = end;
    this.#whole = toNumber(end);
    if (this.#whole > 0) this.#findAll();
  }

  #findAll(): void {
    const { level, rules, taken, aliens, limits, slide } = this.#world;
    const flow = this.#flow;
    for (const [i, c] of level.novae.entries()) this.#contact('nova', i, standing(placeOf(c)), c.radius);
    level.asteroids.forEach((c, i) => {
      if (c.hot) this.#contact('asteroid', i, flow.asteroids[i], c.radius);
    });
    level.aliens.forEach((c, i) => {
      if (!aliens[i].gone) this.#contact('alien', i, flow.aliens[i], c.radius);
    });
    this.#contact('blackHole', 0, standing(placeOf(level.blackHole)), level.blackHole.radius);
    level.minerals.forEach((c, i) => {
      if (!taken[i]) this.#contact('mineral', i, standing(placeOf(c)), c.radius);
    });
    if (this.#world.anchor >= 0) this.#rim('range', 0, flow.asteroids[this.#world.anchor], level.range, true);
    for (const [i, c] of level.repulsors.entries())
      if (slide?.kind !== 'field' || slide.index !== i)
        this.#rim('field', i, standing(placeOf(c)), c.radius, this.#world.fields[i]);
    for (const [i, c] of level.winds.entries())
      if (slide?.kind !== 'wind' || slide.index !== i) this.#rim('wind', i, standing(placeOf(c)), c.radius, this.#world.winds[i]);
    level.wormholes.forEach((c, i) => {
      const state = this.#world.mouths[i];
      const second = secondMouth(c);
      if (state !== 2) this.#rim(state === 0 ? 'jump' : 'mouth', 2 * i, standing(placeOf(c)), c.radius, state === 1);
      if (state !== 1) this.#rim(state === 0 ? 'jump' : 'mouth', 2 * i + 1, standing(second), c.radius, state === 2);
    });
    aliens.forEach((alien, i) => {
      if (!alien.gone) this.#rim('sight', i, flow.aliens[i], rules.alienSight, alien.awake);
    });
    this.#explosions();
    this.#targets();
    for (const [i, line] of flow.centres.entries()) this.#below('centre', i, line, 0, 1);
    if (flow.insideShare !== null) {
      this.#below('slip', 0, flow.insideShare, 1, 1);
      this.#below('slip', 1, shifted(minus(flow.insideShare), 1), 1, 1);
    }
    for (const axis of [0, 1] as const) {
      const sign = limits[axis];
      const speed = axis === 0 ? flow.her.vx : flow.her.vy;
      const force = axis === 0 ? flow.forceX : flow.forceY;
      if (sign !== 0) this.#below('limit', axis, sign > 0 ? force : minus(force), 0, 1);
      else if (Math.abs(speed.hi[0]) + sumAfterFirst(speed, this.#whole) > 0.999 * rules.speedLimit) {
        this.#below('limit', axis, shifted(minus(speed), rules.speedLimit), rules.speedLimit, 1);
        this.#below('limit', axis, shifted(speed, rules.speedLimit), rules.speedLimit, 1);
      }
    }
  }

  /** The most that a path departs from its start up to the end, px. */
  #travel(path: Path): number {
    let most = this.#travels.get(path);
    if (most === undefined) {
      most = roughLength(sumAfterFirst(path.x, this.#whole), sumAfterFirst(path.y, this.#whole)) * (1 + 1e-12) + 1e-9;
      this.#travels.set(path, most);
    }
    return most;
  }

  #tell(kind: Kind, index: number, at: Dd | null, other = -1): void {
    if (at === null) return;
    this.found.push({ kind, index, at, other });
    const until = add(at, dd(CLOSE / this.#flow.unit));
    if (compare(until, this.#end) < 0) this.#end = until;
  }

  #missed(value: number, slope: number): void {
    const margin = value / slope;
    if (margin < EXACT) this.#margins.exact++;
    else this.#margins.narrowest = Math.min(this.#margins.narrowest, margin);
  }

  /**
   * The first moment from which a guard is below 0.
   * @param size - natural size of the numbers that the guard is a difference of
   * @param slope - change of the guard per px
   */
  #below(kind: Kind, index: number, guard: Series, size: number, slope: number, other = -1): void {
    this.#tell(kind, index, this.#first(guard, ZERO, this.#end, size, slope, false), other);
  }

  #first(guard: Series, from: Dd, end: Dd, size: number, slope: number, counted: boolean): Dd | null {
    spend(this.#world, 16);
    const noise = NOTHING * (size + sumAfterFirst(guard, this.#whole));
    if (from.hi > 0) {
      if (Math.abs(valueAt(guard, from).hi) > noise) {
        return firstBelow(
          guard,
          from,
          end,
          () => noise,
          (value) => this.#missed(value, slope),
        );
      }
      // it may be exactly 0 there
      const later = this.#first(about(guard, from), ZERO, subtract(end, from), size, slope, counted);
      return later === null ? null : add(later, from);
    }
    const open = opened(guard, this.#whole, size);
    if (counted && (open === null || open.zeros > 0)) this.#margins.exact++;
    if (open === null) return null;
    const noiseAt = (at: number, zeros: number): number => (zeros === 0 ? noise : noiseAt(at, zeros - 1) / at);
    return firstBelow(
      open.guard,
      from,
      end,
      (at) => noiseAt(toNumber(at), open.zeros),
      (value) => this.#missed(open.zeros === 0 ? value : slope, slope),
    );
  }

  /** Her centre crosses a circle. */
  #rim(kind: Kind, index: number, centre: Path, radius: number, isInside: boolean): void {
    const { her } = this.#flow;
    const d = roughLength(her.x.hi[0] - centre.x.hi[0], her.y.hi[0] - centre.y.hi[0]);
    if (Math.abs(d - radius) > this.#travel(her) + this.#travel(centre) + 1e-12 * d) return;
    const gap = squaredDistance(her, centre);
    gap.set(0, subtract(gap.get(0), times(dd(radius), radius)));
    this.#below(kind, index, isInside ? minus(gap) : gap, 1e-2 * radius * radius, 2 * radius);
  }

  #explosions(): void {
    const { aliens, level } = this.#world;
    const paths = this.#flow.aliens;
    for (let i = 0; i < aliens.length; i++) {
      spend(this.#world, aliens.length / 16);
      for (let j = i + 1; j < aliens.length; j++) {
        if (aliens[i].gone || aliens[j].gone) continue;
        const reach = level.aliens[i].radius + level.aliens[j].radius;
        const d = roughLength(paths[i].x.hi[0] - paths[j].x.hi[0], paths[i].y.hi[0] - paths[j].y.hi[0]);
        if (d - reach > this.#travel(paths[i]) + this.#travel(paths[j])) continue;
        const gap = squaredDistance(paths[i], paths[j]);
        const sum = add(dd(level.aliens[i].radius), dd(level.aliens[j].radius));
        gap.set(0, subtract(gap.get(0), multiply(sum, sum)));
        this.#below('explosion', i, gap, reach * reach, 2 * reach, j);
      }
    }
  }

  /** Another asteroid becomes the nearest. */
  #targets(): void {
    const { held, target } = this.#world;
    if (!held || target < 0) return;
    const { her, asteroids } = this.#flow;
    const distance = (path: Path) => roughLength(her.x.hi[0] - path.x.hi[0], her.y.hi[0] - path.y.hi[0]);
    const own = distance(asteroids[target]);
    const most = this.#travel(her) * 2 + this.#travel(asteroids[target]);
    const to = squaredDistance(her, asteroids[target]);
    asteroids.forEach((path, j) => {
      if (j === target || distance(path) - own > most + this.#travel(path)) return;
      const apart = roughLength(path.x.hi[0] - asteroids[target].x.hi[0], path.y.hi[0] - asteroids[target].y.hi[0]);
      this.#below('target', j, eachOf(squaredDistance(her, path), to, subtract), own * own, Math.max(2 * apart, 1e-9));
    });
  }

  /** Her box touches a circle: by the region of the plane around the box in which its centre is. */
  #contact(kind: Kind, index: number, centre: Path, radius: number): void {
    const { her, cos, sin } = this.#flow;
    const { boxWidth, boxHeight } = this.#world.rules;
    const d = roughLength(her.x.hi[0] - centre.x.hi[0], her.y.hi[0] - centre.y.hi[0]);
    const reach = roughLength(boxWidth, boxHeight) / 2 + radius;
    if (d - reach > this.#travel(her) + this.#travel(centre) + 1e-12 * d) return;
    const dx = eachOf(centre.x, her.x, subtract);
    const dy = eachOf(centre.y, her.y, subtract);
    const x = eachOf(product(dx, cos), product(dy, sin), add);
    const y = eachOf(product(dy, cos), product(dx, sin), subtract);
    const [hw, hh] = [boxWidth / 2, boxHeight / 2];
    const end = this.#end;
    const cuts = [
      ...[shifted(x, hw), shifted(x, -hw), shifted(y, hh), shifted(y, -hh)].flatMap((line) => crossings(line, ZERO, end)),
      end,
    ].sort(compare);
    let from = ZERO;
    for (const to of cuts) {
      if (compare(to, from) <= 0) continue;
      const at = this.#touchedIn(x, y, hw, hh, radius, from, to);
      if (at !== null) {
        this.#tell(kind, index, at);
        return;
      }
      from = to;
    }
  }

  /** The same while the centre stays in one region. */
  #touchedIn(x: Series, y: Series, hw: number, hh: number, radius: number, from: Dd, to: Dd): Dd | null {
    const middle = divide(add(from, to), dd(2));
    const side = (value: number, half: number) => (value > half ? 1 : value < -half ? -1 : 0);
    const sx = side(valueAt(x, middle).hi, hw);
    const sy = side(valueAt(y, middle).hi, hh);
    if (sx === 0 && sy === 0) return from;
    const beyondX = shifted(sx > 0 ? x : minus(x), -hw);
    const beyondY = shifted(sy > 0 ? y : minus(y), -hh);
    if (sy === 0) return this.#first(shifted(beyondX, -radius), from, to, radius + hw, 1, true);
    if (sx === 0) return this.#first(shifted(beyondY, -radius), from, to, radius + hh, 1, true);
    const gap = eachOf(product(beyondX, beyondX), product(beyondY, beyondY), add);
    gap.set(0, subtract(gap.get(0), times(dd(radius), radius)));
    return this.#first(gap, from, to, radius * radius, 2 * radius, true);
  }
}

const minus = (series: Series): Series => eachOf(series, series, negate);

function shifted(series: Series, by: number): Series {
  const made = eachOf(series, series, (a) => a);
  made.set(0, add(series.get(0), dd(by)));
  return made;
}

function squaredDistance(a: Path, b: Path): Series {
  const dx = eachOf(a.x, b.x, subtract);
  const dy = eachOf(a.y, b.y, subtract);
  return eachOf(product(dx, dx), product(dy, dy), add);
}

function sumAfterFirst({ hi }: Series, s: number): number {
  let sum = 0;
  for (let k = 1, power = s; k < hi.length; k++, power *= s) sum += Math.abs(hi[k]) * power;
  return sum;
}

/** Where a path is at a value of the variable, and how fast. */
export const placeAt = (path: Path, s: Dd): Vector => ({ x: valueAt(path.x, s), y: valueAt(path.y, s) });
export const velocityAt = (path: Path, s: Dd): Vector => ({ x: valueAt(path.vx, s), y: valueAt(path.vy, s) });

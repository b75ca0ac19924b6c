import {
  type Dd,
  dd,
  direction,
  dot,
  isShort,
  length,
  minus,
  plus,
  subtract,
  times,
  toNumber,
  twoSum,
  type Vector,
  ZERO,
} from './double-double.ts';
import { speedAcross } from './forces.ts';
import { gapTo, type Happening, KINDS, type Margins, NotCovered, spend } from './stretch.ts';
import { isIn, NO_LENGTH, nearer, nearest, placeOf, secondMouth, type World } from './world.ts';

/** How a run ends. */
export interface Ending {
  readonly outcome: 'completed' | 'collided' | 'lost' | 'timeout';
  readonly with: { readonly kind: 'nova' | 'asteroid' | 'alien' | 'blackHole'; readonly index: number } | null;
}

/** Decides what is the case at an instant, and changes the world accordingly. */
export class Instants {
  ending: Ending | null = null;
  readonly minerals: { index: number; time: Dd }[] = [];
  /** What happened, in order. */
  readonly story: string[] = [];
  readonly margins: Margins = { narrowest: Number.POSITIVE_INFINITY, exact: 0 };
  readonly slides = new Set<'field' | 'wind'>();
  /** Smallest time between two crossings of the rims of fields and winds that are not at one instant, s. */
  quickestCrossing = Number.POSITIVE_INFINITY;
  #lastCrossing = Number.NEGATIVE_INFINITY;
  /** The rims crossed at this instant. */
  readonly #flips = new Set<string>();
  readonly #world: World;

  /** @param world - at the start */
  constructor(world: World) {
    this.#world = world;
  }

  /** The button changes. */
  press(held: boolean): void {
    this.story.push(held ? 'press' : 'release');
    this.#world.held = held;
    if (!held) return;
    this.#aim();
    this.#settle(true);
  }

  /** The gun finds its target, and the box turns to it at once. */
  #aim(): void {
    const world = this.#world;
    world.target = nearest(world);
    if (world.target < 0) return;
    const { at, velocity } = world.asteroids[world.target];
    const u = minus(at, world.her.at);
    // in the very centre: where it is as soon as she has left it
    const v = minus(velocity, world.her.velocity);
    if (!isShort(u, NO_LENGTH)) world.box = direction(u);
    else if (!isShort(v, NO_LENGTH)) world.box = direction(v);
  }

  /** Decides what is the case at the start, before a press at tick 0. */
  start(): void {
    this.#noteStart();
    this.#orient(false);
    this.#settle(this.#findAnchor(false));
    this.#explodeAtStart();
  }

  /** Aliens that overlap at the start are gone before a press at tick 0 turns her, and before what she only touches counts. */
  #explodeAtStart(): void {
    const { aliens, level } = this.#world;
    for (const [i, one] of aliens.entries()) {
      spend(this.#world, aliens.length);
      for (const [j, other] of aliens.entries()) {
        if (j <= i || one.gone || other.gone) continue;
        const reach = twoSum(level.aliens[i].radius, level.aliens[j].radius);
        if (subtract(length(minus(one.at, other.at)), reach).hi >= 0) continue;
        one.gone = true;
        other.gone = true;
        this.#tell('explosion', i, j);
      }
    }
  }

  /** Ends the run if her box, as it stands, touches something, or if she is out of range. */
  #settle(isInRange: boolean): void {
    const world = this.#world;
    const { level, asteroids, aliens, taken } = world;
    level.minerals.forEach((c, i) => {
      if (!taken[i] && this.#overlaps(placeOf(c), c.radius)) this.#take(i);
    });
    const touch = (kind: NonNullable<Ending['with']>['kind'], index: number, at: Vector, radius: number) => {
      if (this.ending !== null || !this.#overlaps(at, radius)) return;
      this.ending = { outcome: kind === 'blackHole' ? 'completed' : 'collided', with: { kind, index } };
    };
    for (const [i, c] of level.novae.entries()) touch('nova', i, placeOf(c), c.radius);
    level.asteroids.forEach((c, i) => {
      if (c.hot) touch('asteroid', i, asteroids[i].at, c.radius);
    });
    level.aliens.forEach((c, i) => {
      if (!aliens[i].gone) touch('alien', i, aliens[i].at, c.radius);
    });
    touch('blackHole', 0, placeOf(level.blackHole), level.blackHole.radius);
    if (this.ending === null && !isInRange) this.ending = { outcome: 'lost', with: null };
  }

  #overlaps(at: Vector, radius: number): boolean {
    const gap = gapTo(this.#world, at, radius);
    this.#noteMargin(gap);
    return gap < 0;
  }

  /** What decides by as little as this decides narrowly, px; by 0 it decides exactly. */
  #noteMargin(margin: number): void {
    if (margin === 0) this.margins.exact++;
    else this.margins.narrowest = Math.min(this.margins.narrowest, Math.abs(margin));
  }

  /** Notes how near the places of the start are to where they would decide otherwise. */
  #noteStart(): void {
    const { level, her, rules, asteroids, aliens } = this.#world;
    const note = (a: Vector, b: Vector, radius: number, more = 0) => {
      const margin = toNumber(subtract(length(minus(a, b)), twoSum(radius, more)));
      this.#noteMargin(Math.abs(margin) < 1e-24 * radius ? 0 : margin);
    };
    for (const c of [...level.repulsors, ...level.winds, ...level.wormholes]) note(placeOf(c), her.at, c.radius);
    for (const c of level.wormholes) note(secondMouth(c), her.at, c.radius);
    for (const { at } of asteroids) note(at, her.at, level.range);
    for (const [i, { at }] of aliens.entries()) {
      note(at, her.at, rules.alienSight);
      for (const [j, other] of aliens.entries()) {
        if (j < i) note(at, other.at, level.aliens[i].radius, level.aliens[j].radius);
      }
    }
  }

  /** Finds in which discs she is, at the start or after a wormhole. */
  #orient(jumped: boolean): void {
    const world = this.#world;
    const { level } = world;
    level.repulsors.forEach((c, i) => {
      world.fields[i] = isIn(world, placeOf(c), c.radius, true);
    });
    level.winds.forEach((c, i) => {
      world.winds[i] = isIn(world, placeOf(c), c.radius, true);
    });
    level.wormholes.forEach((c, i) => {
      const first = isIn(world, placeOf(c), c.radius, jumped);
      const second = isIn(world, secondMouth(c), c.radius, jumped);
      world.mouths[i] = first ? 1 : second ? 2 : 0;
    });
    level.aliens.forEach((_, i) => {
      const alien = world.aliens[i];
      const u = minus(world.her.at, alien.at);
      const depth = subtract(times(dd(world.rules.alienSight), world.rules.alienSight), dot(u, u));
      const awake = depth.hi > 1e-24 * (world.rules.alienSight * world.rules.alienSight);
      if (alien.awake && !awake) alien.velocity = { x: ZERO, y: ZERO };
      alien.awake = awake;
    });
  }

  /**
   * Finds an asteroid in whose range she is and stays.
   * @param leaving - whether being at the very range is not enough
   * @param left - the asteroid whose range she leaves, or -1
   */
  #findAnchor(leaving: boolean, left = -1): boolean {
    const world = this.#world;
    const r2 = times(dd(world.level.range), world.level.range);
    let deepest = Number.NEGATIVE_INFINITY;
    let anchor = -1;
    let alongRange = false;
    world.asteroids.forEach(({ at, velocity }, i) => {
      const u = minus(at, world.her.at);
      const depth = subtract(r2, dot(u, u)).hi;
      const rounding = 1e-24 * r2.hi;
      const closing = dot(u, minus(velocity, world.her.velocity)).hi;
      const isAtRange = Math.abs(depth) <= rounding;
      if (isAtRange && leaving && i !== left && Math.abs(closing) < NO_LENGTH) alongRange = true;
      if (depth > rounding || (isAtRange && (!leaving || closing < 0))) {
        if (depth > deepest) {
          deepest = depth;
          anchor = i;
        }
      }
    });
    if (anchor < 0 && alongRange) throw new NotCovered('along the very range of an asteroid');
    world.anchor = anchor;
    return anchor >= 0;
  }

  #tell(kind: Happening['kind'], index: number, other = -1): void {
    this.story.push(`${kind} ${index}${other < 0 ? '' : ` ${other}`}`);
  }

  #take(index: number): void {
    this.#world.taken[index] = true;
    this.minerals.push({ index, time: this.#world.time });
    this.#tell('mineral', index);
  }

  /**
   * Lets what is at one instant happen, in the order of the rules, up to the first change of the flow.
   * @param isLater - whether it is a later instant than that of the last call
   */
  happen(same: readonly Happening[], isLater: boolean): void {
    if (isLater) this.#flips.clear();
    const order = ({ kind }: Happening) => KINDS.indexOf(kind);
    // A rim that is crossed back at once was crossed for no time: nothing else follows from that.
    const back = same.filter(({ kind, index }) => this.#flips.has(`${kind} ${index}`));
    const sorted = [...(back.length > 0 ? back : same)].sort((a, b) => order(a) - order(b) || a.index - b.index);
    const world = this.#world;
    const targets = sorted.filter(({ kind }) => kind === 'target');
    const change = sorted.find((one) => order(one) > KINDS.indexOf('jump'));
    for (const happening of sorted) {
      const { kind, index, other } = happening;
      // what a change of the flow leaves of the rest is found anew, each rim by itself
      if (change !== undefined && happening !== change && order(happening) >= order(change)) {
        if (kind !== change.kind || kind === 'field' || kind === 'wind') break;
      }
      if (kind === 'mineral') this.#take(index);
      else if (kind === 'nova' || kind === 'asteroid' || kind === 'alien') {
        this.ending = { outcome: 'collided', with: { kind, index } };
        return;
      } else if (kind === 'blackHole') {
        this.ending = { outcome: 'completed', with: { kind, index: 0 } };
        return;
      } else if (kind === 'range') {
        if (!this.#findAnchor(true, world.anchor)) {
          this.ending = { outcome: 'lost', with: null };
          return;
        }
      } else {
        this.#tell(kind, index, other);
        if (kind === 'jump') {
          this.#jump(index);
          return;
        }
        this.#change(happening, targets.length);
      }
    }
    if (world.held && targets.length > 1) world.target = nearer(world);
  }

  #jump(mouth: number): void {
    const world = this.#world;
    const wormhole = world.level.wormholes[mouth >> 1];
    const way = minus(secondMouth(wormhole), placeOf(wormhole));
    world.her.at = mouth % 2 === 0 ? plus(world.her.at, way) : minus(world.her.at, way);
    world.slide = null;
    this.#orient(true);
    world.mouths[mouth >> 1] = mouth % 2 === 0 ? 2 : 1;
    if (world.held) this.#aim();
    this.#settle(this.#findAnchor(true));
  }

  /** She crosses a rim; where she crosses it back at once, at rest across it, she slides on it. */
  #noteFlip(kind: 'field' | 'wind', index: number): void {
    const world = this.#world;
    const rim = `${kind} ${index}`;
    const before = this.#flips.has(rim);
    this.#flips.add(rim);
    if (!before || this.#flips.size > 1) return;
    const disc = kind === 'field' ? world.level.repulsors[index] : world.level.winds[index];
    const { her, limits } = world;
    if (Math.abs(speedAcross(her.at, her.velocity, placeOf(disc), disc.radius)) > 1e-18) return;
    if (limits[0] !== 0 || limits[1] !== 0) throw new NotCovered('slides at the speed limit');
    world.slide = { kind, index };
    this.slides.add(kind);
  }

  /** Changes the flow. */
  #change({ kind, index, other }: Happening, targets: number): void {
    const world = this.#world;
    const { fields, winds, mouths, limits, aliens, level } = world;
    if (kind === 'field' || kind === 'wind') {
      const time = toNumber(world.time);
      // rims that coincide are crossed at the same instant
      if (time > this.#lastCrossing) this.quickestCrossing = Math.min(this.quickestCrossing, time - this.#lastCrossing);
      this.#lastCrossing = time;
      const flags = kind === 'field' ? fields : winds;
      flags[index] = !flags[index];
      this.#noteFlip(kind, index);
    } else if (kind === 'slip') {
      const slide = world.slide!;
      (slide.kind === 'field' ? fields : winds)[slide.index] = index === 1;
      world.slide = null;
      this.#flips.clear();
    } else if (kind === 'mouth') {
      const wormhole = level.wormholes[index >> 1];
      const opposite = index % 2 === 0 ? secondMouth(wormhole) : placeOf(wormhole);
      mouths[index >> 1] = isIn(world, opposite, wormhole.radius, true) ? 2 - (index % 2) : 0;
    } else if (kind === 'target' && targets === 1) world.target = index;
    else if (kind === 'sight') {
      const alien = aliens[index];
      alien.awake = !alien.awake;
      if (!alien.awake) alien.velocity = { x: ZERO, y: ZERO };
    } else if (kind === 'explosion' && !aliens[index].gone && !aliens[other].gone) {
      aliens[index].gone = true;
      aliens[other].gone = true;
    } else if (kind === 'limit') {
      if (world.slide !== null) throw new NotCovered('the speed limit is reached on a rim');
      const axis = index as 0 | 1;
      const speed = axis === 0 ? world.her.velocity.x : world.her.velocity.y;
      const sign = Math.sign(speed.hi);
      limits[axis] = limits[axis] === 0 ? sign : 0;
      const exact = dd(sign * world.rules.speedLimit);
      world.her.velocity = axis === 0 ? { ...world.her.velocity, x: exact } : { ...world.her.velocity, y: exact };
    }
  }
}

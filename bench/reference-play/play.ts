import type { Hold, Level } from '../../schema/index.ts';
import {
  add,
  compare,
  type Dd,
  dd,
  direction,
  divide,
  dot,
  isShort,
  length,
  minus,
  NOWHERE,
  plus,
  subtract,
  times,
  toNumber,
  twoSum,
  type Vector,
  ZERO,
} from './double-double.ts';
import { expand, type Flow } from './flow.ts';
import { Guards, gapTo, type Happening, KINDS, type Kind, type Margins, placeAt, velocityAt } from './guards.ts';
import { NotCovered } from './not-covered.ts';
import { valueAt } from './series.ts';
import { speedAcross } from './sliding.ts';
import { isIn, NO_LENGTH, type Nudge, nearest, placeOf, secondMouth, startOf, type World } from './world.ts';

/** Her state at a moment, with 32 digits. */
export interface Sample {
  /** s from the start. */
  readonly time: Dd;
  readonly at: Vector;
  readonly velocity: Vector;
  /** The direction of the x axis of her box. */
  readonly box: Vector;
}

/** How a run goes in truth. */
export interface Played {
  readonly outcome: 'completed' | 'collided' | 'lost' | 'timeout';
  readonly with: { readonly kind: 'nova' | 'asteroid' | 'alien' | 'blackHole'; readonly index: number } | null;
  readonly end: Sample;
  readonly minerals: readonly { readonly index: number; readonly time: Dd }[];
  /** Her state at every multiple of the sampling interval before the end. */
  readonly samples: readonly Sample[];
  /** What happened, in order, without times: two runs with the same list went the same way. */
  readonly story: readonly string[];
  readonly margins: Margins;
  /** Smallest gap between her box and what ends the run, wherever a stretch begins, px. */
  readonly clearance: number;
  /** On the rims of what she slides. */
  readonly slides: ReadonlySet<'field' | 'wind'>;
  /** Smallest time between two crossings of the rims of fields and winds, s. */
  readonly quickestCrossing: number;
  /** Her smallest distance from a centre past which she does not fly on a line, wherever a stretch begins, px. */
  readonly nearestCentre: number;
  /** Smallest time between two happenings of which one ends the run or moves her elsewhere, s. */
  readonly narrowestOrder: number;
}

export interface PlayOptions {
  /** The run is a timeout then, ticks. */
  readonly maxTicks: number;
  /** Interval between samples, ticks. */
  readonly every: number;
  readonly nudge: Nudge;
}

/** As many happenings at one instant or in one run, or as many stretches, mean that the reference should not go on. */
const MOST_AT_ONCE = 30;
const MOST_HAPPENINGS = 800;
const MOST_STRETCHES = 20_000;

/** Happenings as close as this are at the same instant, s per second of time. */
const SAME_INSTANT = 1e-23;

const ENDS: readonly Kind[] = ['nova', 'asteroid', 'alien', 'blackHole', 'range'];

/**
 * Plays a game in continuous time with 32 digits.
 * @throws NotCovered where the rules and 32 digits do not decide how it goes on
 */
export const play = (level: Level, holds: readonly Hold[], options: PlayOptions): Played => new Game(level, holds, options).run();

class Game {
  readonly #world: World;
  readonly #changes: readonly number[];
  readonly #maxTicks: number;
  readonly #every: number;
  readonly #minerals: { index: number; time: Dd }[] = [];
  readonly #samples: Sample[] = [];
  readonly #story: string[] = [];
  readonly #margins: Margins = { narrowest: Number.POSITIVE_INFINITY, exact: 0 };
  #narrowestOrder = Number.POSITIVE_INFINITY;
  #happenings = 0;
  /** The rims crossed at this instant. */
  readonly #flips = new Set<string>();
  readonly #slides = new Set<'field' | 'wind'>();
  #clearance = Number.POSITIVE_INFINITY;
  #nearestCentre = Number.POSITIVE_INFINITY;
  #quickestCrossing = Number.POSITIVE_INFINITY;
  #lastCrossing = Number.NEGATIVE_INFINITY;
  #ending: Pick<Played, 'outcome' | 'with'> | null = null;

  constructor(level: Level, holds: readonly Hold[], { maxTicks, every, nudge }: PlayOptions) {
    this.#world = startOf(level, nudge);
    this.#changes = changesOf(holds);
    this.#maxTicks = maxTicks;
    this.#every = every;
  }

  run(): Played {
    this.#start();
    let next = 0;
    let atOnce = 0;
    let count = 0;
    while (this.#ending === null) {
      const tick = next < this.#changes.length ? Math.min(this.#changes[next], this.#maxTicks) : this.#maxTicks;
      const boundary = divide(dd(tick), dd(60));
      if (compare(this.#world.time, boundary) < 0) {
        const moved = this.#stretch(boundary);
        atOnce = moved ? 0 : atOnce + 1;
        count++;
        if (atOnce > MOST_AT_ONCE) throw new NotCovered('too much happens at one instant');
        if (count > MOST_STRETCHES || this.#happenings > MOST_HAPPENINGS) throw new NotCovered('too much happens');
        continue;
      }
      if (tick >= this.#maxTicks) break;
      next++;
      this.#press(!this.#world.held);
    }
    const { outcome, with: touched } = this.#ending ?? { outcome: 'timeout' as const, with: null };
    return {
      outcome,
      with: touched,
      end: this.#now(),
      minerals: this.#minerals,
      samples: this.#samples,
      story: this.#story,
      margins: this.#margins,
      narrowestOrder: this.#narrowestOrder,
      clearance: this.#clearance,
      nearestCentre: this.#nearestCentre,
      quickestCrossing: this.#quickestCrossing,
      slides: this.#slides,
    };
  }

  #now(): Sample {
    const { time, her, box } = this.#world;
    return { time, at: her.at, velocity: her.velocity, box };
  }

  #press(held: boolean): void {
    this.#story.push(held ? 'press' : 'release');
    this.#world.held = held;
    if (held) this.#world.target = nearest(this.#world);
  }

  /** Decides what is the case at the start, before a press at tick 0. */
  #start(): void {
    this.#noteStart();
    this.#orient(false);
    this.#settle(this.#findAnchor(false));
  }

  /** Ends the run if her box, as it stands, touches something, or if she is out of range. */
  #settle(isInRange: boolean): void {
    const world = this.#world;
    const { level, asteroids, aliens, taken } = world;
    level.minerals.forEach((c, i) => {
      if (!taken[i]) gapTo(world, placeOf(c), c.radius) < 0 && this.#take(i);
    });
    const touch = (kind: NonNullable<Played['with']>['kind'], index: number, at: Vector, radius: number) => {
      if (this.#ending !== null || !this.#overlaps(at, radius)) return;
      this.#ending = { outcome: kind === 'blackHole' ? 'completed' : 'collided', with: { kind, index } };
    };
    for (const [i, c] of level.novae.entries()) touch('nova', i, placeOf(c), c.radius);
    level.asteroids.forEach((c, i) => {
      if (c.hot) touch('asteroid', i, asteroids[i].at, c.radius);
    });
    level.aliens.forEach((c, i) => {
      if (!aliens[i].gone) touch('alien', i, aliens[i].at, c.radius);
    });
    touch('blackHole', 0, placeOf(level.blackHole), level.blackHole.radius);
    if (this.#ending === null && !isInRange) this.#ending = { outcome: 'lost', with: null };
  }

  #overlaps(at: Vector, radius: number): boolean {
    const gap = gapTo(this.#world, at, radius);
    this.#noteMargin(gap);
    return gap < 0;
  }

  /** What decides by as little as this decides narrowly, px; by 0 it decides exactly. */
  #noteMargin(margin: number): void {
    if (margin !== 0) this.#margins.narrowest = Math.min(this.#margins.narrowest, Math.abs(margin));
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

  /** Finds an asteroid in whose range she is and stays. @param leaving - whether being at the very range is not enough */
  #findAnchor(leaving: boolean): boolean {
    const world = this.#world;
    const r2 = times(dd(world.level.range), world.level.range);
    let deepest = Number.NEGATIVE_INFINITY;
    let anchor = -1;
    world.asteroids.forEach(({ at, velocity }, i) => {
      const u = minus(at, world.her.at);
      const depth = subtract(r2, dot(u, u)).hi;
      const rounding = 1e-24 * r2.hi;
      const stays = !leaving || dot(u, minus(velocity, world.her.velocity)).hi < 0;
      if (depth > rounding || (depth >= -rounding && stays)) {
        if (depth > deepest) {
          deepest = depth;
          anchor = i;
        }
      }
    });
    world.anchor = anchor;
    return anchor >= 0;
  }

  #take(index: number): void {
    this.#world.taken[index] = true;
    this.#minerals.push({ index, time: this.#world.time });
    this.#story.push(`mineral ${index}`);
  }

  /** Moves on until something happens, or the series ends, or a time is reached. Returns whether time has passed. */
  #stretch(boundary: Dd): boolean {
    const world = this.#world;
    const flow = expand(world);
    this.#nearestCentre = Math.min(this.#nearestCentre, flow.besideCentre);
    this.#measureClearance();
    const left = divide(subtract(boundary, world.time), dd(flow.unit));
    const isWhole = toNumber(left) <= flow.reach;
    const end = isWhole ? left : dd(flow.reach);
    const { found } = new Guards(world, flow, end, this.#margins);
    if (!found.every(({ at }) => Number.isFinite(at.hi))) throw new NotCovered('not a number');
    if (found.length === 0) {
      this.#flips.clear();
      this.#moveTo(flow, end, isWhole ? boundary : null);
      return true;
    }
    found.sort((a, b) => compare(a.at, b.at));
    const [first] = found;
    const within = (SAME_INSTANT * (1 + toNumber(world.time))) / flow.unit;
    const same = found.filter(({ at }) => toNumber(subtract(at, first.at)) <= within);
    const later = found.find((one) => !same.includes(one));
    if (later !== undefined && [...same, later].some(({ kind }) => kind === 'jump' || ENDS.includes(kind))) {
      this.#narrowestOrder = Math.min(this.#narrowestOrder, toNumber(subtract(later.at, first.at)) * flow.unit);
    }
    this.#moveTo(flow, first.at, null);
    if (first.at.hi > 0) this.#flips.clear();
    this.#happenings++;
    this.#happen(same);
    return first.at.hi > 0;
  }

  #measureClearance(): void {
    const { level, asteroids, aliens } = this.#world;
    const measure = (at: Vector, radius: number) => {
      // exactly touching is no narrow miss
      const gap = gapTo(this.#world, at, radius);
      if (gap > 0) this.#clearance = Math.min(this.#clearance, gap);
    };
    for (const c of [...level.novae, level.blackHole]) measure(placeOf(c), c.radius);
    level.asteroids.forEach((c, i) => {
      if (c.hot) measure(asteroids[i].at, c.radius);
    });
    level.aliens.forEach((c, i) => {
      if (!aliens[i].gone) measure(aliens[i].at, c.radius);
    });
  }

  #moveTo(flow: Flow, s: Dd, time: Dd | null): void {
    const world = this.#world;
    const until = time ?? add(world.time, times(s, flow.unit));
    for (;;) {
      const sampled = divide(dd(this.#samples.length * this.#every), dd(60));
      if (compare(sampled, until) >= 0) break;
      const at = divide(subtract(sampled, world.time), dd(flow.unit));
      this.#samples.push({
        time: sampled,
        at: placeAt(flow.her, at),
        velocity: velocityAt(flow.her, at),
        box: { x: valueAt(flow.cos, at), y: valueAt(flow.sin, at) },
      });
    }
    world.her.at = placeAt(flow.her, s);
    world.her.velocity = velocityAt(flow.her, s);
    world.box = { x: valueAt(flow.cos, s), y: valueAt(flow.sin, s) };
    world.asteroids.forEach((body, i) => {
      if (flow.asteroids[i].stands) return;
      body.at = placeAt(flow.asteroids[i], s);
      body.velocity = velocityAt(flow.asteroids[i], s);
    });
    world.aliens.forEach((body, i) => {
      if (flow.aliens[i].stands) return;
      body.at = placeAt(flow.aliens[i], s);
      body.velocity = velocityAt(flow.aliens[i], s);
    });
    world.time = until;
  }

  /** Lets everything happen that is at one instant, in the order of the rules. */
  #happen(same: readonly Happening[]): void {
    const order = ({ kind }: Happening) => KINDS.indexOf(kind);
    const sorted = [...same].sort((a, b) => order(a) - order(b) || a.index - b.index);
    const world = this.#world;
    const targets = sorted.filter(({ kind }) => kind === 'target');
    for (const happening of sorted) {
      const { kind, index, other } = happening;
      if (kind === 'mineral') this.#take(index);
      else if (kind === 'nova' || kind === 'asteroid' || kind === 'alien') {
        this.#ending = { outcome: 'collided', with: { kind, index } };
        return;
      } else if (kind === 'blackHole') {
        this.#ending = { outcome: 'completed', with: { kind, index: 0 } };
        return;
      } else if (kind === 'range') {
        if (!this.#findAnchor(true)) {
          this.#ending = { outcome: 'lost', with: null };
          return;
        }
      } else {
        this.#story.push(`${kind} ${index}${other < 0 ? '' : ` ${other}`}`);
        if (kind === 'jump') {
          this.#jump(index);
          return;
        }
        this.#change(happening, targets.length);
      }
    }
    if (world.held && targets.length > 1) world.target = nearest(world);
  }

  #jump(mouth: number): void {
    const world = this.#world;
    const wormhole = world.level.wormholes[mouth >> 1];
    const way = minus(secondMouth(wormhole), placeOf(wormhole));
    world.her.at = mouth % 2 === 0 ? plus(world.her.at, way) : minus(world.her.at, way);
    world.slide = null;
    this.#orient(true);
    world.mouths[mouth >> 1] = mouth % 2 === 0 ? 2 : 1;
    if (world.held) {
      world.target = nearest(world);
      const u = world.target < 0 ? NOWHERE : minus(world.asteroids[world.target].at, world.her.at);
      if (!isShort(u, NO_LENGTH)) world.box = direction(u);
    }
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
    this.#slides.add(kind);
  }

  /** Changes the flow. */
  #change({ kind, index, other }: Happening, targets: number): void {
    const world = this.#world;
    const { fields, winds, mouths, limits, aliens, level } = world;
    if (kind === 'field' || kind === 'wind') {
      const time = toNumber(world.time);
      this.#quickestCrossing = Math.min(this.#quickestCrossing, time - this.#lastCrossing);
      this.#lastCrossing = time;
    }
    if (kind === 'field' || kind === 'wind') {
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

/** The ticks at which the button changes, holds joined. */
function changesOf(holds: readonly Hold[]): number[] {
  const joined: [number, number][] = [];
  for (const [press, release] of [...holds].sort((a, b) => a[0] - b[0])) {
    if (press >= release) continue;
    const last = joined.at(-1);
    if (last !== undefined && press <= last[1]) last[1] = Math.max(last[1], release);
    else joined.push([press, release]);
  }
  return joined.flat();
}

import type { Hold, Level } from '../../../schema/basics/index.ts';
import {
  add,
  compare,
  type Dd,
  dd,
  divide,
  minus,
  roughLength,
  subtract,
  times,
  toNumber,
  type Vector,
} from './double-double.ts';
import { type Ending, Instants } from './instants.ts';
import { type Body, gapTo, type Kind, type Margins, type Method, NotCovered, type Stretch, spend } from './stretch.ts';
import { type Nudge, placeOf, startOf, type World } from './world.ts';

/** Her state at a moment, with 32 digits. */
export interface Sample extends Body {
  /** s from the start. */
  readonly time: Dd;
}

/** How a run goes in truth. */
export interface Played extends Ending {
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
  /** How motion is computed and what happens is located. */
  readonly method: Method;
  /** The run is a timeout then, ticks. */
  readonly maxTicks: number;
  /** Interval between samples, ticks. */
  readonly every: number;
  readonly nudge: Nudge;
  /** Work after which the reference gives up: about as many evaluations of a force or a guard. */
  readonly mostWork: number;
}

/** As many happenings at one instant, or in one run, mean that the reference should not go on. */
const MOST_AT_ONCE = 30;
const MOST_HAPPENINGS = 800;

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
  readonly #instants: Instants;
  readonly #changes: readonly number[];
  readonly #method: Method;
  readonly #maxTicks: number;
  readonly #every: number;
  readonly #samples: Sample[] = [];
  #narrowestOrder = Number.POSITIVE_INFINITY;
  #happenings = 0;
  #clearance = Number.POSITIVE_INFINITY;
  #nearestCentre = Number.POSITIVE_INFINITY;

  constructor(level: Level, holds: readonly Hold[], { method, maxTicks, every, nudge, mostWork }: PlayOptions) {
    this.#method = method;
    this.#world = startOf(level, nudge);
    this.#world.left = mostWork;
    this.#instants = new Instants(this.#world);
    this.#changes = changesOf(holds);
    this.#maxTicks = maxTicks;
    this.#every = every;
  }

  run(): Played {
    const instants = this.#instants;
    instants.start();
    let next = 0;
    let atOnce = 0;
    while (instants.ending === null) {
      const tick = next < this.#changes.length ? Math.min(this.#changes[next], this.#maxTicks) : this.#maxTicks;
      const boundary = divide(dd(tick), dd(60));
      if (compare(this.#world.time, boundary) < 0) {
        const moved = this.#stretch(boundary);
        atOnce = moved ? 0 : atOnce + 1;
        if (atOnce > MOST_AT_ONCE) throw new NotCovered('too much happens at one instant');
        if (this.#happenings > MOST_HAPPENINGS) throw new NotCovered('too much happens');
        continue;
      }
      if (tick >= this.#maxTicks) break;
      next++;
      instants.press(!this.#world.held);
    }
    const { outcome, with: touched } = instants.ending ?? { outcome: 'timeout' as const, with: null };
    return {
      outcome,
      with: touched,
      end: this.#now(),
      minerals: instants.minerals,
      samples: this.#samples,
      story: instants.story,
      margins: instants.margins,
      narrowestOrder: this.#narrowestOrder,
      clearance: this.#clearance,
      nearestCentre: this.#nearestCentre,
      quickestCrossing: instants.quickestCrossing,
      slides: instants.slides,
    };
  }

  #now(): Sample {
    const { time, her, box } = this.#world;
    return { time, at: her.at, velocity: her.velocity, box };
  }

  /** Moves on until something happens, or the series ends, or a time is reached. Returns whether time has passed. */
  #stretch(boundary: Dd): boolean {
    const world = this.#world;
    spend(world, 200 + (world.asteroids.length + world.aliens.length + world.taken.length + world.level.novae.length) / 8);
    const stretch = this.#method(world);
    this.#nearestCentre = Math.min(this.#nearestCentre, stretch.besideCentre);
    this.#measureClearance();
    const left = divide(subtract(boundary, world.time), dd(stretch.unit));
    const isWhole = toNumber(left) <= stretch.reach;
    const end = isWhole ? left : dd(stretch.reach);
    const found = stretch.happenings(end, this.#instants.margins);
    if (!found.every(({ at }) => Number.isFinite(at.hi))) throw new NotCovered('not a number');
    if (found.length === 0) {
      this.#moveTo(stretch, end, isWhole ? boundary : null);
      return true;
    }
    found.sort((a, b) => compare(a.at, b.at));
    const [first] = found;
    const within = (SAME_INSTANT * (1 + toNumber(world.time))) / stretch.unit;
    const same = found.filter(({ at }) => toNumber(subtract(at, first.at)) <= within);
    const later = found.find((one) => !same.includes(one));
    if (later !== undefined && [...same, later].some(({ kind }) => kind === 'jump' || ENDS.includes(kind))) {
      this.#narrowestOrder = Math.min(this.#narrowestOrder, toNumber(subtract(later.at, first.at)) * stretch.unit);
    }
    this.#moveTo(stretch, first.at, null);
    this.#happenings++;
    this.#instants.happen(same, first.at.hi > 0);
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

  #moveTo(stretch: Stretch, s: Dd, time: Dd | null): void {
    const world = this.#world;
    const until = time ?? add(world.time, times(s, stretch.unit));
    for (;;) {
      const sampled = divide(dd(this.#samples.length * this.#every), dd(60));
      // what happens at this very moment comes first, whatever the last digits say
      if (toNumber(subtract(sampled, until)) > -SAME_INSTANT) break;
      const at = divide(subtract(sampled, world.time), dd(stretch.unit));
      this.#samples.push({ time: sampled, ...stretch.bodyAt(at) });
    }
    stretch.moveTo(s);
    world.time = until;
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

/** The largest distance between two references at ticks before the earlier of their ends, px. */
export function apart(a: Played, b: Played): number {
  let largest = 0;
  for (let i = 0; i < Math.min(a.samples.length, b.samples.length); i++) {
    const u = minus(a.samples[i].at, b.samples[i].at);
    largest = Math.max(largest, roughLength(u.x.hi, u.y.hi));
  }
  return largest;
}

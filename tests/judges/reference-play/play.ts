import type { Hold, Level } from '../../../schema/index.ts';
import { add, compare, type Dd, dd, divide, subtract, times, toNumber, type Vector } from './double-double.ts';
import { expand, type Flow } from './flow.ts';
import { Guards, gapTo, type Kind, type Margins, placeAt, velocityAt } from './guards.ts';
import { type Ending, Instants } from './instants.ts';
import { NotCovered } from './not-covered.ts';
import { valueAt } from './series.ts';
import { type Nudge, placeOf, startOf, type World } from './world.ts';

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
  readonly #instants: Instants;
  readonly #changes: readonly number[];
  readonly #maxTicks: number;
  readonly #every: number;
  readonly #samples: Sample[] = [];
  #narrowestOrder = Number.POSITIVE_INFINITY;
  #happenings = 0;
  #clearance = Number.POSITIVE_INFINITY;
  #nearestCentre = Number.POSITIVE_INFINITY;

  constructor(level: Level, holds: readonly Hold[], { maxTicks, every, nudge }: PlayOptions) {
    this.#world = startOf(level, nudge);
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
    let count = 0;
    while (instants.ending === null) {
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
    const flow = expand(world);
    this.#nearestCentre = Math.min(this.#nearestCentre, flow.besideCentre);
    this.#measureClearance();
    const left = divide(subtract(boundary, world.time), dd(flow.unit));
    const isWhole = toNumber(left) <= flow.reach;
    const end = isWhole ? left : dd(flow.reach);
    const { found } = new Guards(world, flow, end, this.#instants.margins);
    if (!found.every(({ at }) => Number.isFinite(at.hi))) throw new NotCovered('not a number');
    if (found.length === 0) {
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

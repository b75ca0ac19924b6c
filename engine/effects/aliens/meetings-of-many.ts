import { ALERTNESS, type Motion, RECORDS, SLOTS } from '../../motion/index.ts';

const { AWAKE_COUNT } = SLOTS;
const { CHASER } = RECORDS;
const { ASLEEP } = ALERTNESS;

/** From this many awake aliens on, an index made for the piece finds the near ones. */
export const MANY_AWAKE = 16;

/** Margin of distances at which something cannot matter, px; far above any rounding. */
export const MARGIN = 1e-3;

/** Takes the place of a second alien where there is none. */
export const NOBODY = -1;

/** Who is awake and who sleeps where. */
interface Sleepers {
  /** Indices of the aliens that are awake, ascending. */
  readonly awake: Int32Array;
  /** Indices, ascending, of at least all sleepers whose disc reaches nearer than `reach` px to (x, y), px from the origin. */
  sleepersAround(x: number, y: number, reach: number): ArrayLike<number>;
}

/** What awake aliens may touch. */
interface NearSleepers {
  /** A sleeper and an awake one after it in the list, sorted. */
  readonly before: readonly (readonly [number, number])[];
  /** For each awake one, sleepers after it. */
  readonly after: readonly (readonly number[])[];
}

/** Pairs of a sleeper and an awake alien that are kept at most. */
const MOST_KEPT = 100_000;

/** A function that visits the pairs whose first is before `end`, and goes on from there the next time. */
function inTurn(pairs: NearSleepers['before'], visit: (i: number, j: number) => void): (end: number) => void {
  let next = 0;
  return (end) => {
    for (; next < pairs.length && pairs[next][0] < end; next++) visit(pairs[next][0], pairs[next][1]);
  };
}

/** As `AlienCrowd.meetings`, for many aliens: its memory grows with the number of aliens, and not with that of pairs. */
export class MeetingsOfMany {
  /** By the place in the list of those that are awake: how far each may come and still touch, with its own radius, px. */
  private reach = new Float64Array(0);

  constructor(
    private readonly m: Motion,
    private readonly crowd: Sleepers,
  ) {}

  visit(h: number, isEnough: () => boolean, visit: (i: number, j: number) => void): void {
    const { m } = this;
    const { awake } = this.crowd;
    const count = m.s[AWAKE_COUNT];
    m.budget.look(4 * count);
    this.measure(h, count);
    const partners = this.partnersAmongAwake(h);
    const near = isEnough() ? null : this.nearSleepers(count);
    const sleepersBefore = near === null ? this.sleepersOneByOne(count, isEnough, visit) : inTurn(near.before, visit);
    for (let k = 0; k < count; k++) {
      const i = awake[k];
      sleepersBefore(i);
      if (!isEnough()) {
        const all = partners(k);
        m.budget.look(2 + 3 * all.length);
        for (const j of near?.after[k] ?? this.sleepersAfter(k)) all.push(j);
        const sorted = ascending(all);
        for (let at = 0; at < sorted.length; at++) visit(i, sorted[at]);
      }
      visit(i, NOBODY);
    }
    sleepersBefore(m.scene.aliens.count);
  }

  private measure(h: number, count: number): void {
    const { s, chasers, scene, rules } = this.m;
    if (this.reach.length < count) this.reach = new Float64Array(Math.max(count, 2 * this.reach.length));
    for (let k = 0; k < count; k++) {
      const i = this.crowd.awake[k];
      const o = chasers + CHASER * i;
      const far = (Math.sqrt(s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3]) + rules.alienPull * h) * h;
      this.reach[k] = far + scene.aliens.r[i];
    }
  }

  /** Whether the k-th awake alien may touch a sleeper. */
  private mayTouch(k: number, j: number): boolean {
    const { s, chasers, scene } = this.m;
    const o = chasers + CHASER * this.crowd.awake[k];
    const q = chasers + CHASER * j;
    const reach = this.reach[k] + scene.aliens.r[j] + MARGIN;
    return !(Math.abs(s[q] - s[o]) > reach || Math.abs(s[q + 1] - s[o + 1]) > reach);
  }

  private sleepersNear(k: number): ArrayLike<number> {
    const { s, chasers, scene, budget } = this.m;
    const o = chasers + CHASER * this.crowd.awake[k];
    const found = this.crowd.sleepersAround(s[o], s[o + 1], this.reach[k]);
    if (scene.aliens.spatial !== null) budget.look(found.length >> 2);
    return found;
  }

  /** The sleepers that awake ones may touch; null when the pairs are too many to be kept. */
  private nearSleepers(count: number): NearSleepers | null {
    const before: [number, number][] = [];
    const after: number[][] = [];
    let kept = 0;
    for (let k = 0; k < count; k++) {
      const i = this.crowd.awake[k];
      const near = this.sleepersNear(k);
      const later: number[] = [];
      for (let at = 0; at < near.length; at++) {
        const j = near[at];
        if (!this.mayTouch(k, j)) continue;
        if (++kept > MOST_KEPT) return null;
        if (j < i) before.push([j, i]);
        else later.push(j);
      }
      after.push(later);
    }
    before.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    return { before, after };
  }

  /** A function that visits the pairs of those that sleep, up to the alien `end`, and goes on from there the next time. */
  private sleepersOneByOne(count: number, isEnough: () => boolean, visit: (i: number, j: number) => void): (end: number) => void {
    const { s, chasers } = this.m;
    let awakeAround: ((j: number) => ArrayLike<number>) | null = null;
    let next = 0;
    return (end) => {
      for (; next < end; next++) {
        if (s[chasers + CHASER * next + 4] !== ASLEEP || isEnough()) continue;
        awakeAround ??= this.awakeAround(count);
        const near = awakeAround(next);
        for (let k = 0; k < near.length; k++) visit(next, near[k]);
      }
    };
  }

  /** The sleepers after the k-th awake alien that it may touch. */
  private sleepersAfter(k: number): number[] {
    const later: number[] = [];
    const near = this.sleepersNear(k);
    for (let at = 0; at < near.length; at++)
      if (near[at] > this.crowd.awake[k] && this.mayTouch(k, near[at])) later.push(near[at]);
    return later;
  }

  /** For a sleeper: the awake aliens after it in the list that may touch it, ascending. */
  private awakeAround(count: number): (j: number) => ArrayLike<number> {
    const { s, chasers, scene, parts, budget } = this.m;
    const { awake } = this.crowd;
    const at = (coordinate: number) =>
      Float64Array.from({ length: count }, (_, k) => s[chasers + CHASER * awake[k] + coordinate]);
    // twice the margin: rounding must not hide what `mayTouch` finds
    const r = this.reach.slice(0, count).map((reach) => reach + 2 * MARGIN);
    const index = parts.indexing.circles({ count, x: at(0), y: at(1), r, index: Int32Array.from(awake.subarray(0, count)) });
    const everyone = Array.from({ length: count }, (_, k) => k);
    return (j) => {
      const q = chasers + CHASER * j;
      const found = index?.around(s[q], s[q + 1], scene.aliens.r[j]) ?? everyone;
      budget.look(found.length >> 2);
      return ascending(found.filter((k) => awake[k] > j && this.mayTouch(k, j)).map((k) => awake[k]));
    };
  }

  /** For the k-th awake alien: the awake ones after it in the list that it may touch within `h` s. */
  private partnersAmongAwake(h: number): (k: number) => number[] {
    const { s, chasers, scene, rules, parts } = this.m;
    const { r } = scene.aliens;
    const { awake } = this.crowd;
    const count = s[AWAKE_COUNT];
    if (count <= MANY_AWAKE) return (k) => Array.from(awake.subarray(k + 1, count));
    let vx = 0;
    let vy = 0;
    for (let k = 0; k < count; k++) {
      vx += s[chasers + CHASER * awake[k] + 2] / count;
      vy += s[chasers + CHASER * awake[k] + 3] / count;
    }
    // relative to a point with their mean velocity, each stays in a box: straight motion, and as far aside as the pull takes it
    const boxes = new Float64Array(4 * count);
    for (let k = 0; k < count; k++) {
      const o = chasers + CHASER * awake[k];
      const dx = (s[o + 2] - vx) * h;
      const dy = (s[o + 3] - vy) * h;
      const room = r[awake[k]] + rules.alienPull * h * h + MARGIN;
      boxes[4 * k] = s[o] + Math.min(0, dx) - room;
      boxes[4 * k + 1] = s[o + 1] + Math.min(0, dy) - room;
      boxes[4 * k + 2] = s[o] + Math.max(0, dx) + room;
      boxes[4 * k + 3] = s[o + 1] + Math.max(0, dy) + room;
    }
    const partners = parts.indexing.boxes(boxes);
    return (k) => partners(k).map((other) => awake[other]);
  }
}

/** Above this length, a typed array is sorted sooner. */
const SHORT = 64;

/** Indices, ascending. The list may be changed. */
export const ascending = (found: number[]): ArrayLike<number> =>
  found.length > SHORT ? Int32Array.from(found).sort() : found.sort((a, b) => a - b);

import type { SpatialIndex } from '../../indexed-circles.ts';
import { ALERTNESS, type Crowd, type Motion, RECORDS, SLOTS, type Vicinity } from '../../motion/index.ts';
import { ascending, MANY_AWAKE, MARGIN, MeetingsOfMany, NOBODY } from './meetings-of-many.ts';
import { overlapping } from './pair.ts';

const { AWAKE_COUNT } = SLOTS;
const { CHASER } = RECORDS;
const { ASLEEP, AWAKE, GONE } = ALERTNESS;

/** When more sleepers than this are elsewhere than in the index, the index is made anew. */
const MOST_ASTRAY = 256;

/**
 * Which aliens are awake, and where the others sleep. All of it follows from the state and is derived from it after a restore.
 * It changes only when an alien wakes, falls asleep or explodes, so sleepers cost nothing while she is away from them.
 */
export class AlienCrowd implements Crowd {
  /** Indices of the aliens that are awake, ascending; the state has their number. */
  readonly awake: Int32Array;
  /** Aliens that woke, fell asleep or exploded since this list was emptied; for a recorder. */
  readonly altered: number[] = [];
  /** Whether any of them may differ from the start. */
  changed = false;
  /** The index of places; null if there is none. */
  private index: SpatialIndex | null;
  /** The places it was made of, px from the origin; null for those in the level. */
  private indexedX: Float64Array | null = null;
  private indexedY: Float64Array | null = null;
  /** Sleepers that are elsewhere than in the index. */
  private astray: number[] = [];
  /** Entries of the list of explosions before this index are done. */
  private explosion = 0;
  /** The meetings of many aliens, which are found one alien after the other; null if there are few. */
  private meetingsOfMany: MeetingsOfMany | null = null;

  /** @param near - which sleepers she may wake or touch */
  constructor(
    private readonly m: Motion,
    private readonly near: Vicinity,
  ) {
    const { aliens } = m.scene;
    this.awake = new Int32Array(aliens.count);
    this.index = aliens.spatial;
  }

  /** Index in the list of explosions of the first pair that sleeps, overlapping; -1 if there is none. */
  overlapAtStart(): number {
    const { s, chasers, scene } = this.m;
    const { explosions } = scene.aliens;
    let isFirst = true;
    for (let k = this.explosion; k < explosions.length; k += 2) {
      const a = chasers + CHASER * explosions[k];
      const b = chasers + CHASER * explosions[k + 1];
      if (s[a + 4] === GONE || s[b + 4] === GONE) {
        if (isFirst) this.explosion = k + 2;
        continue;
      }
      isFirst = false;
      if (s[a + 4] !== ASLEEP || s[b + 4] !== ASLEEP) continue;
      if (overlapping(this.m, explosions[k], explosions[k + 1])) return k;
    }
    return -1;
  }

  /** Derives everything from the state, after it was replaced. */
  read(): void {
    const { s, chasers, scene } = this.m;
    let count = 0;
    this.astray = [];
    for (let i = 0; i < scene.aliens.count; i++) {
      const o = chasers + CHASER * i;
      if (s[o + 4] === AWAKE) this.awake[count++] = i;
      else if (this.index !== null && s[o + 4] === ASLEEP && this.isAstray(i)) this.astray.push(i);
    }
    this.near.forget();
    this.explosion = 0;
  }

  wake(i: number): void {
    const { s } = this.m;
    const { awake } = this;
    let k = s[AWAKE_COUNT]++;
    for (; k > 0 && awake[k - 1] > i; k--) awake[k] = awake[k - 1];
    awake[k] = i;
    if (this.index !== null && this.isAstray(i)) this.astray = this.astray.filter((j) => j !== i);
    this.become(i, AWAKE);
  }

  sleep(i: number): void {
    this.dismiss(i);
    this.become(i, ASLEEP);
    this.near.forget();
    if (this.index === null || !this.isAstray(i)) return;
    this.astray.push(i);
    if (this.astray.length > MOST_ASTRAY) this.reindex();
  }

  explode(i: number): void {
    if (this.m.s[this.m.chasers + CHASER * i + 4] === AWAKE) this.dismiss(i);
    this.become(i, GONE);
  }

  private become(i: number, alertness: number): void {
    const { s, chasers } = this.m;
    s[chasers + CHASER * i + 4] = alertness;
    this.changed = true;
    if (this.m.recorder?.keeps) this.altered.push(i);
  }

  private dismiss(i: number): void {
    const { s } = this.m;
    const { awake } = this;
    const count = --s[AWAKE_COUNT];
    let k = awake.indexOf(i);
    for (; k < count; k++) awake[k] = awake[k + 1];
  }

  private isAstray(i: number): boolean {
    const { s, chasers, scene, originX, originY } = this.m;
    const { indexedX, indexedY } = this;
    const o = chasers + CHASER * i;
    const x = indexedX === null ? scene.aliens.x[i] - originX : indexedX[i];
    const y = indexedY === null ? scene.aliens.y[i] - originY : indexedY[i];
    return s[o] !== x || s[o + 1] !== y;
  }

  private reindex(): void {
    const { s, chasers, scene, originX, originY } = this.m;
    const { aliens } = scene;
    const x = aliens.x.map((_, i) => s[chasers + CHASER * i]);
    const y = aliens.y.map((_, i) => s[chasers + CHASER * i + 1]);
    this.indexedX = x;
    this.indexedY = y;
    this.index = this.m.parts.indexing.circles({ ...aliens, x: x.map((at) => at + originX), y: y.map((at) => at + originY) });
    this.astray = [];
  }

  /** Indices, ascending, of at least all sleepers whose disc reaches nearer than `reach` px to (x, y), px from the origin. */
  sleepersAround(x: number, y: number, reach: number): ArrayLike<number> {
    const { s, chasers, scene, originX, originY, budget } = this.m;
    const { count } = scene.aliens;
    const found: number[] = [];
    if (this.index === null) {
      for (let i = 0; i < count; i++) if (s[chasers + CHASER * i + 4] === ASLEEP) found.push(i);
      return found;
    }
    const there = this.index.around(x + originX, y + originY, reach + MARGIN);
    for (const i of there) {
      if (s[chasers + CHASER * i + 4] === ASLEEP && !this.isAstray(i)) found.push(i);
    }
    // where many are awake or gone, they are most of what is looked at
    budget.look((there.length - found.length) >> 5);
    for (const i of this.astray) found.push(i);
    return ascending(found);
  }

  /**
   * Calls `visit` with every sleeper, ascending, that she may wake or touch before she is `within` px from (x, y), and with its
   * distance.
   */
  eachSleeperNear(x: number, y: number, within: number, visit: (i: number, distance: number) => void): void {
    const { s, chasers, originX, originY } = this.m;
    const isKnown = this.near.covers(x + originX, y + originY, within + MARGIN);
    const found = isKnown ? this.near.found : this.look(x, y, within + MARGIN);
    for (let k = 0; k < found.length; k++) {
      const o = chasers + CHASER * found[k];
      if (s[o + 4] !== ASLEEP) continue;
      visit(found[k], Math.sqrt((s[o] - x) * (s[o] - x) + (s[o + 1] - y) * (s[o + 1] - y)));
    }
  }

  /** Looks for sleepers that she may wake or touch within `within` px of (x, y), and how far others are. */
  private look(x: number, y: number, within: number): ArrayLike<number> {
    const { s, chasers, scene, box, rules, budget, originX, originY } = this.m;
    const { r, count } = scene.aliens;
    const edge = (i: number): number => {
      const o = chasers + CHASER * i;
      if (s[o + 4] !== ASLEEP) return Number.POSITIVE_INFINITY;
      const d = Math.sqrt((s[o] - x) * (s[o] - x) + (s[o + 1] - y) * (s[o + 1] - y));
      return d - Math.max(rules.alienSight, r[i] + box.halfDiagonal);
    };
    if (this.index === null) return this.near.fill(x + originX, y + originY, within, count, edge, null);
    const beyond = Math.max(rules.alienSight, box.halfDiagonal) + MARGIN;
    const search = (far: number) => Array.from(this.sleepersAround(x, y, far + beyond)).filter((i) => !(edge(i) > far));
    const found = this.near.fill(x + originX, y + originY, within, count, edge, search);
    budget.look(found.length >> 2);
    return found;
  }

  /**
   * Finds at least all pairs with an awake alien that may touch within `h` s from the start of the piece, sorted by the first and
   * then by the second. After the pairs of an awake first alien comes an entry for that alien itself, with NOBODY as the second.
   * Which events are found first can depend on this order; it is that of examining all pairs.
   *
   * There may be as many pairs as aliens squared, so of many aliens only those of one first alien are kept at a time.
   * @param isEnough whether no further pair can matter; then only entries with NOBODY have to come
   * @param visit gets them one by one
   */
  meetings(h: number, isEnough: () => boolean, visit: (i: number, j: number) => void): void {
    const { s, chasers, scene } = this.m;
    const { count } = scene.aliens;
    if (count > MANY_AWAKE) {
      this.meetingsOfMany ??= new MeetingsOfMany(this.m, this);
      this.meetingsOfMany.visit(h, isEnough, visit);
      return;
    }
    for (let i = 0; i < count; i++) {
      const state = s[chasers + CHASER * i + 4];
      if (state === GONE) continue;
      for (let j = i + 1; j < count; j++) {
        const other = s[chasers + CHASER * j + 4];
        if (other === AWAKE || (state === AWAKE && other === ASLEEP)) visit(i, j);
      }
      if (state === AWAKE) visit(i, NOBODY);
    }
  }
}

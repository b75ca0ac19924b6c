import type { Scene, Simulation } from '../../../engine/index.ts';

const EMPTY = -1;

/**
 * Maps cells to the nodes that represent them: a hash table with open addressing, whose keys are the two 32-bit hashes of a
 * cell.
 */
export class CellTable {
  private mask: number;
  private low: Int32Array;
  private high: Int32Array;
  private node: Int32Array;
  private size = 0;

  constructor(capacity = 1024) {
    this.mask = capacity - 1;
    this.low = new Int32Array(capacity);
    this.high = new Int32Array(capacity);
    this.node = new Int32Array(capacity).fill(EMPTY);
  }

  /** The slot of the cell with these hashes, taken or not. It is valid until the next `put`. */
  find(low: number, high: number): number {
    let i = (low ^ (high >>> 7)) & this.mask;
    while (this.node[i] !== EMPTY && (this.low[i] !== low || this.high[i] !== high)) i = (i + 1) & this.mask;
    return i;
  }

  /** The node in a slot, or -1. */
  at(place: number): number {
    return this.node[place];
  }

  put(place: number, low: number, high: number, node: number): void {
    if (this.node[place] === EMPTY) this.size++;
    this.low[place] = low;
    this.high[place] = high;
    this.node[place] = node;
    if (2 * this.size > this.mask) this.grow();
  }

  clear(): void {
    this.node.fill(EMPTY);
    this.size = 0;
  }

  private grow(): void {
    const { low, high, node } = this;
    const capacity = 2 * (this.mask + 1);
    this.mask = capacity - 1;
    this.low = new Int32Array(capacity);
    this.high = new Int32Array(capacity);
    this.node = new Int32Array(capacity).fill(EMPTY);
    for (let i = 0; i < node.length; i++) {
      if (node[i] === EMPTY) continue;
      const place = this.find(low[i], high[i]);
      this.low[place] = low[i];
      this.high[place] = high[i];
      this.node[place] = node[i];
    }
  }
}

/** The places of this many chasers at most distinguish cells. */
const CHASERS = 32;

const mix = (h: number, k: number): number => Math.imul(h ^ k ^ (h >>> 15), 0x2c1b3c6d);
const stir = (h: number, k: number): number => Math.imul(h ^ k ^ (h >>> 13), 0x297a2d39);

/**
 * Computes the cell of a state as two 32-bit hashes of her place and velocity in units of the cell size, the places of the
 * chasers, and the minerals she has.
 */
export class CellKey {
  low = 0;
  high = 0;
  private readonly originX: number;
  private readonly originY: number;
  private readonly chasers: Float64Array;

  constructor(scene: Scene) {
    this.originX = scene.level.astronaut.x;
    this.originY = scene.level.astronaut.y;
    this.chasers = new Float64Array(3 * scene.aliens.count);
  }

  /**
   * @param state as `readState` gives it
   * @param place side of a cell, px
   * @param speed side of a cell, px/s
   * @param minerals a hash of the minerals she has
   */
  find(simulation: Simulation, state: Float64Array, place: number, speed: number, minerals: number): void {
    const x = Math.floor((state[0] - this.originX) / place);
    const y = Math.floor((state[1] - this.originY) / place);
    // Shift by a half, so that rest lies in the middle of a cell and not at the corner of four.
    const vx = Math.floor(state[2] / speed + 0.5);
    const vy = Math.floor(state[3] / speed + 0.5);
    let low = mix(mix(mix(mix(minerals ^ 0x3c6ef372, x), y), vx), vy);
    let high = stir(stir(stir(stir(minerals ^ 0x1b873593, vy), vx), y), x);
    const { chasers } = this;
    if (chasers.length > 0) {
      simulation.readAliens(chasers);
      for (let i = 0; i < chasers.length && i < 3 * CHASERS; i += 3) {
        const ax = Math.floor((chasers[i] - this.originX) / place);
        const ay = Math.floor((chasers[i + 1] - this.originY) / place);
        low = mix(mix(low, ax), ay ^ (chasers[i + 2] << 30));
        high = stir(stir(high, ay), ax ^ (chasers[i + 2] << 30));
      }
    }
    this.low = low ^ (low >>> 16);
    this.high = high ^ (high >>> 16);
  }
}

/**
 * Stores numbered snapshots of one scene in a few large typed arrays, so that storing one allocates nothing once its slot
 * exists.
 */
export class SnapshotPool {
  private readonly length: number;
  private readonly places: Float64Array[] = [];

  /** @param length doubles in a snapshot */
  constructor(length: number) {
    this.length = length;
  }

  /** The slot of snapshot `i`. Slots are created in order, one block at a time. */
  at(i: number): Float64Array {
    while (i >= this.places.length) this.grow();
    return this.places[i];
  }

  private grow(): void {
    const { length } = this;
    // The first blocks are small, because a search of a millisecond must not spend it on memory.
    const count = Math.max(1, Math.min(Math.max(16, this.places.length), Math.floor(131072 / length)));
    const block = new Float64Array(count * length);
    for (let k = 0; k < count; k++) this.places.push(block.subarray(k * length, (k + 1) * length));
  }
}

/** The search aims at this many minerals at most. In levels with more of them, enough are collected by chance. */
const AIMED_AT = 24;

/**
 * The minerals that a simulation has collected, where the goal requires any. Each counts once, although `arcade` may count one
 * twice.
 */
export class MineralSet {
  /** How many different minerals she has. */
  size = 0;
  /** A hash of which ones she has. */
  hash = 0;
  /** Which of those aimed at she has, one bit per index. */
  collected = 0;
  private readonly scene: Scene;
  private readonly needed: number;
  private counted = -1;

  /** @param needed how many minerals the goal requires */
  constructor(scene: Scene, needed: number) {
    this.scene = scene;
    this.needed = needed;
  }

  /** How many minerals the search aims at, collected or not: the first ones in the level's list. */
  get aims(): number {
    return this.needed > 0 ? Math.min(this.scene.minerals.count, AIMED_AT) : 0;
  }

  /** Which of those aimed at she still has to collect, one bit per index; 0 when she has enough. */
  get missing(): number {
    return this.size >= this.needed ? 0 : ~this.collected & ((1 << this.aims) - 1);
  }

  /** Reads the minerals again if the count has changed since the last reading. */
  update(simulation: Simulation): void {
    if (simulation.mineralCount !== this.counted) this.read(simulation);
  }

  read(simulation: Simulation): void {
    this.counted = simulation.mineralCount;
    this.size = 0;
    this.hash = 0;
    this.collected = 0;
    if (this.needed === 0 || this.counted === 0) return;
    for (let i = 0; i < this.scene.minerals.count; i++) {
      if (!simulation.isCollected(i)) continue;
      this.size++;
      if (i < AIMED_AT) this.collected |= 1 << i;
      this.hash = Math.imul(this.hash ^ (i + 1), 0x9e3779b1);
    }
  }
}

import { type Scene, TICK_RATE } from '../../../engine/index.ts';
import type { LineOfFlight } from './line-of-flight.ts';

/** Height of a band, px of way. */
const BAND = 40;

/** Bands of one set of minerals, at most. */
export const BANDS = 1000;

/** The bands of this many sets of missing minerals are kept. */
const MOST_KNOWN = 64;

/** The longest drift that is looked along, ticks. */
const DRIFT = 600;

/**
 * Tells how far states still have to go, along the ways around hazards. The ways to the black hole and to each mineral are
 * measured backwards, once. What lies equally far along them forms a band; a door, a gap that every way passes, lies between two
 * bands. A search that shares its effort equally among bands spends it where she has just arrived, and not at the doors she has
 * already passed again and again.
 */
export class Guide {
  private readonly map: WayMap;
  private readonly toHole: Int32Array;
  private readonly toMineral: readonly Int32Array[];
  /** Lengths in a field that make a band. */
  private readonly band: number;
  private readonly known = new Map<number, Uint16Array>();
  private lastMissing = -1;
  private last: Uint16Array = new Uint16Array(0);

  private constructor(scene: Scene, map: WayMap, aims: number) {
    const { minerals, box, level } = scene;
    this.map = map;
    this.band = (5 * BAND) / map.size;
    const hole = level.blackHole;
    this.toHole = map.fieldTo(hole.x, hole.y, hole.radius + box.halfDiagonal);
    this.toMineral = Array.from({ length: aims }, (_, i) =>
      map.fieldTo(minerals.x[i], minerals.y[i], minerals.r[i] + box.halfDiagonal),
    );
  }

  /** @param aims how many minerals are aimed at
   * @returns null where the level is too large to be measured */
  static of(scene: Scene, aims: number): Guide | null {
    const map = WayMap.of(scene);
    return map === null ? null : new Guide(scene, map, aims);
  }

  /**
   * The band of a place, the nearest first.
   * @param missing the minerals still to be collected, one bit per index; 0 when only the black hole is left
   */
  bandAt(x: number, y: number, missing: number): number {
    const square = this.map.squareAt(x, y);
    return square < 0 ? BANDS - 1 : this.bandsFor(missing)[square];
  }

  /**
   * The lowest band that she would pass if the button were released now, on a straight line up to the next hazard.
   * @returns the band, or one that is higher than all when none is lower than `below`
   */
  bandAhead(state: Float64Array, missing: number, below: number, line: LineOfFlight): number {
    const { map } = this;
    const bands = this.bandsFor(missing);
    const speed = Math.sqrt(state[2] * state[2] + state[3] * state[3]);
    if (!(speed > 1)) return BANDS;
    const step = map.size;
    const ux = (state[2] / speed) * step;
    const uy = (state[3] / speed) * step;
    const most = Math.floor((speed * DRIFT) / TICK_RATE / step);
    let x = state[0];
    let y = state[1];
    let best = below;
    let at = 0;
    for (let i = 1; i <= most; i++) {
      x += ux;
      y += uy;
      const square = map.squareAt(x, y);
      if (!map.isFree(square)) break;
      const band = bands[square];
      if (band >= best) continue;
      best = band;
      at = i;
    }
    if (at === 0) return BANDS;
    line.from(state);
    return line.isClear(at * step) ? best : BANDS;
  }

  /** The band of each square of the map. */
  private bandsFor(missing: number): Uint16Array {
    if (missing === this.lastMissing) return this.last;
    let bands = this.known.get(missing);
    if (bands === undefined) {
      bands = this.measure(missing);
      if (this.known.size >= MOST_KNOWN) this.known.clear();
      this.known.set(missing, bands);
    }
    this.lastMissing = missing;
    this.last = bands;
    return bands;
  }

  private measure(missing: number): Uint16Array {
    const fields = missing === 0 ? [this.toHole] : this.toMineral.filter((_, i) => (missing >> i) & 1);
    const bands = new Uint16Array(this.toHole.length);
    for (let square = 0; square < bands.length; square++) {
      let length = NO_WAY;
      for (const field of fields) if (field[square] < length) length = field[square];
      bands[square] = Math.min(BANDS - 1, Math.floor(length / this.band));
    }
    return bands;
  }
}

/** Side of a square at first, px. It doubles until a field has at most `MOST_SQUARES`; beyond `COARSEST` no door is seen. */
const FINEST = 8;
const COARSEST = 16;
const MOST_SQUARES = 120_000;

/** The most squares that all circles together may cover while the map is made, so that crowded levels cost little. */
const MOST_STAMPED = 20_000_000;

/** How far her centre stays from a hazard at least, px: a little less than half the short side of her box. */
const CLEAR = 9;

/** Costs of a step along a side and across a corner, a good approximation of 1 and the square root of 2. */
const STRAIGHT = 5;
const ACROSS = 7;

/** What no way leads from. */
export const NO_WAY = 0x7fffffff;

/**
 * A map of where she can be at all: in range of an asteroid, and not in a nova or a hot asteroid. On it, {@link fieldTo} measures
 * the way from everywhere to a circle, around hazards and through the gaps between them. What chases or pushes her and recoil are left
 * out: the map guides a search and proves nothing.
 */
export class WayMap {
  /** Side of a square, px. */
  readonly size: number;
  private readonly left: number;
  private readonly top: number;
  readonly width: number;
  private readonly height: number;
  private readonly free: Uint8Array;

  private constructor(left: number, top: number, width: number, height: number, size: number) {
    this.left = left;
    this.top = top;
    this.size = size;
    this.width = width;
    this.height = height;
    this.free = new Uint8Array(width * height);
  }

  /** Returns null where the level is too large for a map that shows doors. */
  static of(scene: Scene): WayMap | null {
    const { targets, novae, coldCount, level } = scene;
    const hole = level.blackHole;
    let left = Math.min(level.astronaut.x, hole.x);
    let right = Math.max(level.astronaut.x, hole.x);
    let top = Math.min(level.astronaut.y, hole.y);
    let bottom = Math.max(level.astronaut.y, hole.y);
    for (let i = 0; i < targets.count; i++) {
      left = Math.min(left, targets.x[i] - level.range);
      right = Math.max(right, targets.x[i] + level.range);
      top = Math.min(top, targets.y[i] - level.range);
      bottom = Math.max(bottom, targets.y[i] + level.range);
    }
    let size = FINEST;
    while (((right - left) / size + 3) * ((bottom - top) / size + 3) > MOST_SQUARES) size *= 2;
    if (size > COARSEST) return null;
    const across = (2 * level.range) / size;
    if (targets.count * across * across > MOST_STAMPED) return null;
    const width = Math.ceil((right - left) / size) + 3;
    const height = Math.ceil((bottom - top) / size) + 3;
    const map = new WayMap(left - size, top - size, width, height, size);
    for (let i = 0; i < targets.count; i++) map.stamp(targets.x[i], targets.y[i], level.range, 1);
    for (let i = 0; i < novae.count; i++) map.stamp(novae.x[i], novae.y[i], novae.r[i] + CLEAR, 0);
    for (let i = coldCount; i < targets.count; i++) map.stamp(targets.x[i], targets.y[i], targets.r[i] + CLEAR, 0);
    return map;
  }

  /** The square of a place; -1 outside the map. */
  squareAt(x: number, y: number): number {
    const column = Math.floor((x - this.left) / this.size);
    const row = Math.floor((y - this.top) / this.size);
    return column < 0 || row < 0 || column >= this.width || row >= this.height ? -1 : row * this.width + column;
  }

  /** Whether she can be in a square. */
  isFree(square: number): boolean {
    return square >= 0 && this.free[square] === 1;
  }

  /**
   * Measures the way to where her box can touch a circle (Dijkstra's algorithm, with a list of squares for each distance).
   * @param reach how near her centre has to come to the circle's, px
   * @returns the length of the way for each square, in fifths of a square's side; `NO_WAY` where there is none
   */
  fieldTo(x: number, y: number, reach: number): Int32Array {
    const { width, free } = this;
    const field = new Int32Array(free.length).fill(NO_WAY);
    const steps = [1, -1, width, -width, width + 1, width - 1, 1 - width, -width - 1];
    // squares at distance d stand in list d modulo 8, since a step costs at most 7
    const lists: number[][] = Array.from({ length: 8 }, () => []);
    let waiting = 0;
    this.each(x, y, reach, (square) => {
      if (free[square] === 0) return;
      field[square] = 0;
      lists[0].push(square);
      waiting++;
    });
    for (let d = 0; waiting > 0; d++) {
      const list = lists[d & 7];
      for (const square of list) {
        waiting--;
        if (field[square] !== d) continue;
        for (let k = 0; k < 8; k++) {
          const next = square + steps[k];
          const length = d + (k < 4 ? STRAIGHT : ACROSS);
          if (free[next] === 0 || field[next] <= length) continue;
          field[next] = length;
          lists[length & 7].push(next);
          waiting++;
        }
      }
      list.length = 0;
    }
    return field;
  }

  private stamp(x: number, y: number, r: number, value: number): void {
    this.each(x, y, r, (square) => {
      this.free[square] = value;
    });
  }

  /** Calls for each square within the map's margin whose centre lies within `r` of a place. */
  private each(x: number, y: number, r: number, call: (square: number) => void): void {
    const { size, left, top, width, height } = this;
    const first = Math.max(1, Math.floor((y - r - top) / size));
    const last = Math.min(height - 2, Math.floor((y + r - top) / size));
    for (let row = first; row <= last; row++) {
      const dy = top + (row + 0.5) * size - y;
      const half = Math.sqrt(Math.max(0, r * r - dy * dy));
      const from = Math.max(1, Math.ceil((x - half - left) / size - 0.5));
      const to = Math.min(width - 2, Math.floor((x + half - left) / size - 0.5));
      for (let column = from; column <= to; column++) call(row * width + column);
    }
  }
}

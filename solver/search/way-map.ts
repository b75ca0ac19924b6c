import type { Scene } from '../../engine/index.ts';

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

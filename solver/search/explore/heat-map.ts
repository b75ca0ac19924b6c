import type { Explored } from './search.ts';

/** Side of a square of the map, px. */
const SIZE = 32;

const hash = (x: number, y: number, layer: number): number => {
  const h = Math.imul(Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ layer, 0xcc9e2d51);
  return h ^ (h >>> 15);
};

/** Sums the visits of several searches that start at the same place. */
export class HeatTally {
  private readonly cells = new Map<string, { x: number; y: number; visits: number }>();

  add({ cells }: Explored): void {
    for (const { x, y, visits } of cells) {
      const key = `${x} ${y}`;
      const cell = this.cells.get(key);
      if (cell === undefined) this.cells.set(key, { x, y, visits });
      else cell.visits += visits;
    }
  }

  /** The sum, with the visits of searches that are still going on added. */
  explored(...more: readonly Explored[]): Explored {
    const all = new HeatTally();
    all.add({ cellSize: SIZE, cells: [...this.cells.values()] });
    for (const one of more) all.add(one);
    return { cellSize: SIZE, cells: [...all.cells.values()] };
  }
}

/**
 * Counts the visits to each square of the level, separately for each set of collected minerals (the layer). Squares are aligned
 * to the start, and numbered in the order in which they are found.
 */
export class HeatMap {
  /** Visits of each square, by its number. */
  visits: Int32Array = new Int32Array(128);
  private count = 0;
  private x = new Int32Array(128);
  private y = new Int32Array(128);
  private layer = new Int32Array(128);
  private table = new Int32Array(256).fill(-1);
  private last = -1;
  private readonly originX: number;
  private readonly originY: number;

  constructor(originX: number, originY: number) {
    this.originX = originX;
    this.originY = originY;
  }

  /**
   * Counts one visit of a place in px.
   * @returns the number of its square
   */
  visit(px: number, py: number, layer: number): number {
    const square = this.squareAt(px, py, layer);
    this.visits[square]++;
    return square;
  }

  /** The number of the square that contains a place in px. */
  squareAt(px: number, py: number, layer: number): number {
    const x = Math.floor((px - this.originX) / SIZE);
    const y = Math.floor((py - this.originY) / SIZE);
    const { last } = this;
    if (last >= 0 && this.x[last] === x && this.y[last] === y && this.layer[last] === layer) return last;
    const mask = this.table.length - 1;
    let i = hash(x, y, layer) & mask;
    for (;;) {
      const square = this.table[i];
      if (square < 0) break;
      if (this.x[square] === x && this.y[square] === y && this.layer[square] === layer) {
        this.last = square;
        return square;
      }
      i = (i + 1) & mask;
    }
    if (this.count === this.x.length) {
      this.grow();
      return this.squareAt(px, py, layer);
    }
    const square = this.count++;
    this.table[i] = square;
    this.x[square] = x;
    this.y[square] = y;
    this.layer[square] = layer;
    this.last = square;
    return square;
  }

  /** A number for the region of a square: equal for the nine squares of a three by three block. */
  districtOf(square: number): number {
    return Math.imul(Math.floor(this.x[square] / 3), 0x9e3779b1) ^ Math.imul(Math.floor(this.y[square] / 3), 0x85ebca6b);
  }

  explored(): Explored {
    const cells = new Map<string, { x: number; y: number; visits: number }>();
    for (let i = 0; i < this.count; i++) {
      if (this.visits[i] === 0) continue;
      const key = `${this.x[i]} ${this.y[i]}`;
      const cell = cells.get(key);
      if (cell !== undefined) cell.visits += this.visits[i];
      else {
        const x = this.originX + (this.x[i] + 0.5) * SIZE;
        cells.set(key, { x, y: this.originY + (this.y[i] + 0.5) * SIZE, visits: this.visits[i] });
      }
    }
    return { cellSize: SIZE, cells: [...cells.values()] };
  }

  private grow(): void {
    const doubled = (array: Int32Array) => {
      const larger = new Int32Array(2 * array.length);
      larger.set(array);
      return larger;
    };
    this.x = doubled(this.x);
    this.y = doubled(this.y);
    this.layer = doubled(this.layer);
    this.visits = doubled(this.visits);
    this.table = new Int32Array(2 * this.table.length).fill(-1);
    const mask = this.table.length - 1;
    for (let square = 0; square < this.count; square++) {
      let i = hash(this.x[square], this.y[square], this.layer[square]) & mask;
      while (this.table[i] >= 0) i = (i + 1) & mask;
      this.table[i] = square;
    }
  }
}

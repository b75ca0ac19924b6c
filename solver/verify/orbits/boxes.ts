/** Numbers of a box: bounds of up to five coordinates. */
export const SIZE = 10;

/** Numbers that name a cell: its chart, and where it lies along up to five coordinates. */
const NAME = 6;

/**
 * The boxes of one time, at most one in each cell of the grid: what is put into a cell is joined to what is there. Even
 * coordinates of a box are least values, odd ones greatest.
 */
export class Boxes {
  count = 0;
  private names = new Int32Array(NAME * 1024);
  private bounds = new Float64Array(SIZE * 1024);
  private table = new Int32Array(4096).fill(-1);

  /** Forgets all boxes. */
  clear(): void {
    this.count = 0;
    this.table.fill(-1);
  }

  /** The chart of box n. */
  chartOf(n: number): number {
    return this.names[NAME * n];
  }

  /** Copies the bounds of box n. */
  read(n: number, to: Float64Array): void {
    const from = SIZE * n;
    for (let k = 0; k < SIZE; k++) to[k] = this.bounds[from + k];
  }

  /** Joins a box to the one in its cell. */
  join(chart: number, a: number, b: number, c: number, d: number, e: number, box: Float64Array): void {
    const { table, names, bounds } = this;
    const last = table.length - 1;
    let at = hash(chart, a, b, c, d, e) & last;
    for (let n = table[at]; n >= 0; n = table[at]) {
      const o = NAME * n;
      if (
        names[o + 1] === a &&
        names[o + 2] === b &&
        names[o + 3] === c &&
        names[o + 4] === d &&
        names[o + 5] === e &&
        names[o] === chart
      ) {
        const to = SIZE * n;
        for (let k = 0; k < SIZE; k += 2) {
          if (box[k] < bounds[to + k]) bounds[to + k] = box[k];
          if (box[k + 1] > bounds[to + k + 1]) bounds[to + k + 1] = box[k + 1];
        }
        return;
      }
      at = (at + 1) & last;
    }
    table[at] = this.count;
    this.append(chart, a, b, c, d, e, box);
  }

  private append(chart: number, a: number, b: number, c: number, d: number, e: number, box: Float64Array): void {
    const n = this.count++;
    if (SIZE * (n + 1) > this.bounds.length) this.grow();
    const o = NAME * n;
    this.names[o] = chart;
    this.names[o + 1] = a;
    this.names[o + 2] = b;
    this.names[o + 3] = c;
    this.names[o + 4] = d;
    this.names[o + 5] = e;
    for (let k = 0; k < SIZE; k++) this.bounds[SIZE * n + k] = box[k];
  }

  private grow(): void {
    const names = new Int32Array(2 * this.names.length);
    names.set(this.names);
    this.names = names;
    const bounds = new Float64Array(2 * this.bounds.length);
    bounds.set(this.bounds);
    this.bounds = bounds;
    this.table = new Int32Array(2 * this.table.length).fill(-1);
    const last = this.table.length - 1;
    for (let n = 0; n < this.count; n++) {
      const o = NAME * n;
      let at = hash(names[o], names[o + 1], names[o + 2], names[o + 3], names[o + 4], names[o + 5]) & last;
      while (this.table[at] >= 0) at = (at + 1) & last;
      this.table[at] = n;
    }
  }
}

function hash(chart: number, a: number, b: number, c: number, d: number, e: number): number {
  let h = Math.imul(chart + 1, 0x9e3779b1) ^ a;
  h = Math.imul(h, 0x85ebca6b) ^ b;
  h = Math.imul(h ^ (h >>> 15), 0xc2b2ae35) ^ c;
  h = Math.imul(h, 0x27d4eb2f) ^ d;
  h = Math.imul(h ^ (h >>> 13), 0x165667b1) ^ e;
  h = Math.imul(h, 0x9e3779b1);
  return h ^ (h >>> 16);
}

/** Numbers of a box: least and greatest of each of six numbers. */
export const NUMBERS = 12;

const EMPTY = -1;

/**
 * The boxes of one moment by the cell in which they lie: a hash table with open addressing, whose boxes lie in one array. Boxes of
 * one cell are joined to their hull.
 */
export class Layer {
  private cells: Int32Array = new Int32Array(1024).fill(EMPTY);
  private keys: Float64Array = new Float64Array(512);
  /** The chart of each box. */
  charts: Int32Array = new Int32Array(512);
  /** A number of bits for each box; those of joined boxes are united. */
  marks: Int32Array = new Int32Array(512);
  /** The boxes one after the other. */
  boxes: Float64Array = new Float64Array(512 * NUMBERS);
  /** Number of boxes. */
  size = 0;

  /** Removes all boxes. */
  clear(): void {
    this.cells.fill(EMPTY);
    this.size = 0;
  }

  /** Joins a box with what is in its cell. */
  join(key: number, chart: number, mark: number, box: Float64Array): void {
    let at = this.find(key);
    const there = this.cells[at];
    if (there !== EMPTY) {
      const { boxes } = this;
      this.marks[there] |= mark;
      for (let i = 0, o = there * NUMBERS; i < NUMBERS; i += 2, o += 2) {
        if (box[i] < boxes[o]) boxes[o] = box[i];
        if (box[i + 1] > boxes[o + 1]) boxes[o + 1] = box[i + 1];
      }
      return;
    }
    if (this.size === this.keys.length) {
      this.grow();
      at = this.find(key);
    }
    this.cells[at] = this.size;
    this.keys[this.size] = key;
    this.charts[this.size] = chart;
    this.marks[this.size] = mark;
    this.boxes.set(box, this.size * NUMBERS);
    this.size++;
  }

  /** The place of a key in the table, or the free place where it belongs. */
  private find(key: number): number {
    const { cells, keys } = this;
    const mask = cells.length - 1;
    let hash = Math.imul((key % 4294967296) | 0, 0x9e3779b1) ^ Math.imul((key / 4294967296) | 0, 0x85ebca6b);
    hash ^= hash >>> 15;
    let at = hash & mask;
    while (cells[at] !== EMPTY && keys[cells[at]] !== key) at = (at + 1) & mask;
    return at;
  }

  private grow(): void {
    const twice = <A extends Float64Array | Int32Array>(from: A, to: A): A => {
      to.set(from);
      return to;
    };
    this.keys = twice(this.keys, new Float64Array(2 * this.keys.length));
    this.marks = twice(this.marks, new Int32Array(2 * this.marks.length));
    this.charts = twice(this.charts, new Int32Array(2 * this.charts.length));
    this.boxes = twice(this.boxes, new Float64Array(2 * this.boxes.length));
    this.cells = new Int32Array(2 * this.cells.length).fill(EMPTY);
    for (let i = 0; i < this.size; i++) this.cells[this.find(this.keys[i])] = i;
  }
}

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

/** The least and the greatest square of a number between two. */
export const leastSquare = (a: number, b: number): number => (a > 0 ? a * a : b < 0 ? b * b : 0);
export const mostSquare = (a: number, b: number): number => Math.max(a * a, b * b);

/** Tightens radial speed, momentum and energy of a polar box by each other; false when nothing is left. */
export function agree(part: Float64Array): boolean {
  const p0 = leastSquare(part[8], part[9]) / (part[1] * part[1]);
  const p1 = mostSquare(part[8], part[9]) / (part[0] * part[0]);
  const most = 2 * part[11] - p0 + 1e-4;
  if (most < 0) return false;
  const W = Math.sqrt(most);
  if (part[4] < -W) part[4] = -W;
  if (part[5] > W) part[5] = W;
  const lo = 2 * part[10] - p1 - 1e-4;
  if (lo > 0) {
    const s = Math.sqrt(lo);
    if (part[4] > -s && part[4] < s) part[4] = s;
    if (part[5] < s && part[5] > -s) part[5] = -s;
  }
  if (part[4] > part[5]) return false;
  const q0 = leastSquare(part[4], part[5]);
  const q1 = mostSquare(part[4], part[5]);
  const e0 = (q0 + p0) / 2 - 1e-4;
  const e1 = (q1 + p1) / 2 + 1e-4;
  if (part[10] < e0) part[10] = e0;
  if (part[11] > e1) part[11] = e1;
  if (part[10] > part[11]) return false;
  const l = part[1] * Math.sqrt(Math.max(0, 2 * part[11] - q0)) + 1e-3;
  if (part[9] > l) part[9] = l;
  if (part[8] < -l) part[8] = -l;
  if (part[8] > part[9]) return false;
  const d = (Math.sqrt(leastSquare(part[8], part[9])) - 1e-3) / Math.sqrt(Math.max(1e-9, 2 * part[11] - q0 + 1e-3));
  if (part[0] < d) part[0] = d;
  return part[0] <= part[1];
}

/** What is shown on the way, for tests and pictures. */
export interface OrbitWatch {
  /** Called with the boxes at the start of each step, which is numbered from 0. */
  readonly layer?: (layer: Layer, step: number) => void;
  /** Called with rectangles that contain the places of a part of a step: least and greatest x and y, px from the start. */
  readonly places?: (x0: number, x1: number, y0: number, y1: number) => void;
}

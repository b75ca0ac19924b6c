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

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

import type { Random } from '../random.ts';

/** Nodes from which something has not been tried yet, in no order. */
export class OpenList {
  private nodes = new Int32Array(256);
  private count = 0;

  add(node: number): void {
    if (this.count === this.nodes.length) {
      const larger = new Int32Array(2 * this.count);
      larger.set(this.nodes);
      this.nodes = larger;
    }
    this.nodes[this.count++] = node;
  }

  clear(): void {
    this.count = 0;
  }

  /**
   * Draws `candidates` nodes at random, and removes and returns the one with the lowest score.
   * @param score gives the score of a node; a node that scores positive infinity is dropped from the list and does not count as
   * drawn
   * @returns the node, or -1 when there is none
   */
  take(random: Random, candidates: number, score: (node: number) => number): number {
    let best = -1;
    let bestScore = Number.POSITIVE_INFINITY;
    for (let drawn = 0; drawn < candidates && this.count > 0; ) {
      const i = random.below(this.count);
      const value = score(this.nodes[i]);
      if (value === Number.POSITIVE_INFINITY) {
        this.nodes[i] = this.nodes[--this.count];
        // Dropping a node moves the last one into its place: follow it if it is the best so far.
        if (best === this.count) best = i;
        continue;
      }
      drawn++;
      if (value >= bestScore) continue;
      best = i;
      bestScore = value;
    }
    if (best < 0) return -1;
    const node = this.nodes[best];
    this.nodes[best] = this.nodes[--this.count];
    return node;
  }
}

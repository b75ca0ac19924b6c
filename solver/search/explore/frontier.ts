import type { Random } from '../../random.ts';

/** How often the cells of a stratum shrink at most. */
const FINEST = 12;

/**
 * How much the order counts: the effort of the n-th stratum, from 0, is in proportion to 1 / (ORDER + n). So those near the goal
 * get more, and the others do not starve.
 */
const ORDER = 2;

interface Stratum {
  readonly id: number;
  readonly toPress: OpenList;
  readonly toCoast: OpenList;
  /** All nodes of the stratum. */
  readonly nodes: number[];
  spent: number;
  refined: number;
}

/**
 * The nodes, divided into numbered strata, and what has not been tried yet from them. Each stratum has a share of the effort, those
 * with low numbers more. The one that has had the least of its share comes first, so a new one gets all effort until it has
 * caught up with the others.
 */
export class Frontier {
  private strata = new Map<number, Stratum>();
  /** All strata by rank, those nearest to the goal first. */
  private order: Stratum[] = [];
  private last: Stratum | undefined;

  clear(): void {
    this.strata = new Map();
    this.order = [];
    this.last = undefined;
  }

  /** Adds a node. It is open if something can be tried from it. */
  add(node: number, stratum: number, open: boolean): void {
    const { nodes, toPress, toCoast } = this.at(stratum);
    nodes.push(node);
    if (!open) return;
    toPress.add(node);
    toCoast.add(node);
  }

  spend(stratum: number, ticks: number): void {
    this.at(stratum).spent += ticks;
  }

  /** The stratum that has had the least of its share of the effort. */
  least(): number {
    let least = 0;
    let leastSpent = Number.POSITIVE_INFINITY;
    for (let n = 0; n < this.order.length; n++) {
      const spent = this.order[n].spent * (ORDER + n);
      if (spent >= leastSpent) continue;
      least = this.order[n].id;
      leastSpent = spent;
    }
    return least;
  }

  /** Removes and returns an open node of a stratum as {@link OpenList.take} does; -1 if there is none. */
  take(stratum: number, held: boolean, random: Random, candidates: number, score: (node: number) => number): number {
    const { toPress, toCoast } = this.at(stratum);
    return (held ? toPress : toCoast).take(random, candidates, score);
  }

  /** How often the cells of a stratum have shrunk. */
  refinedOf(stratum: number): number {
    return this.at(stratum).refined;
  }

  /**
   * Removes all nodes of a stratum and returns them, to be added again with smaller cells.
   */
  refine(stratum: number): readonly number[] {
    const one = this.at(stratum);
    one.toPress.clear();
    one.toCoast.clear();
    one.refined = Math.min(FINEST, one.refined + 1);
    return one.nodes.splice(0);
  }

  private at(id: number): Stratum {
    if (this.last?.id === id) return this.last;
    let stratum = this.strata.get(id);
    if (stratum === undefined) {
      stratum = { id, toPress: new OpenList(), toCoast: new OpenList(), nodes: [], spent: 0, refined: 0 };
      this.strata.set(id, stratum);
      const place = this.order.findIndex((other) => other.id > id);
      this.order.splice(place < 0 ? this.order.length : place, 0, stratum);
    }
    this.last = stratum;
    return stratum;
  }
}

/** Nodes from which something has not been tried yet, in no order. */
class OpenList {
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

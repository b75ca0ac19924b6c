import { joinHolds } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';

const doubled = (array: Int32Array): Int32Array => {
  const larger = new Int32Array(2 * array.length);
  larger.set(array);
  return larger;
};

/** The nodes of the search tree. Each is the state at the end of a stretch in which the button was either held or not. */
export class NodeList {
  /** The holds before the first node. */
  private readonly lead: readonly Hold[];
  count = 0;
  parent: Int32Array = new Int32Array(256);
  tick: Int32Array = new Int32Array(256);
  /** Bit 0: whether the button was held on the way here. Other bits: what has been tried from here. */
  flags: Int32Array = new Int32Array(256);
  /** Number of the heat map's square that contains the state. */
  square: Int32Array = new Int32Array(256);
  /** How many different minerals she has, where the goal requires any. */
  minerals: Int32Array = new Int32Array(256);
  /** The stratum of the frontier that the state belongs to. */
  stratum: Int32Array = new Int32Array(256);

  constructor(lead: readonly Hold[] = []) {
    this.lead = lead;
  }

  add(parent: number, tick: number, held: boolean, square: number, minerals: number, stratum: number): number {
    if (this.count === this.parent.length) {
      this.parent = doubled(this.parent);
      this.tick = doubled(this.tick);
      this.flags = doubled(this.flags);
      this.square = doubled(this.square);
      this.minerals = doubled(this.minerals);
      this.stratum = doubled(this.stratum);
    }
    const node = this.count++;
    this.parent[node] = parent;
    this.tick[node] = tick;
    this.flags[node] = held ? 1 : 0;
    this.square[node] = square;
    this.minerals[node] = minerals;
    this.stratum[node] = stratum;
    return node;
  }

  /** Whether the button was held in the stretch that ends at a node. */
  isHeld(node: number): boolean {
    return (this.flags[node] & 1) === 1;
  }

  /** The holds on the way to a node, followed by a hold up to tick `until` when `held`. */
  holdsTo(node: number, until: number, held: boolean): Hold[] {
    const holds: [number, number][] = [];
    const add = (from: number, to: number) => {
      const next = holds[holds.length - 1];
      if (next !== undefined && next[0] === to) next[0] = from;
      else holds.push([from, to]);
    };
    if (held && until > this.tick[node]) add(this.tick[node], until);
    for (let n = node; this.parent[n] >= 0; n = this.parent[n]) {
      if (this.isHeld(n)) add(this.tick[this.parent[n]], this.tick[n]);
    }
    holds.reverse();
    return this.lead.length === 0 ? holds : joinHolds([...this.lead, ...holds]);
  }
}

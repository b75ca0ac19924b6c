import { boxCircleGap, joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Candidate, Replay } from '../../verified-run.ts';
import type { HeatMap } from './heat-map.ts';
import type { Closest } from './search.ts';

// What a search records: the tree of its stretches, the closest approach, and the runs that it has found.

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

/** Records the closest approach to the black hole of all stretches. */
export class Approach {
  private readonly scene: Scene;
  private distance = Number.POSITIVE_INFINITY;
  private node = -1;
  private tick = 0;
  private held = false;
  private holds: readonly Hold[] | null = null;

  constructor(scene: Scene) {
    this.scene = scene;
  }

  /** Examines a state on a stretch from `node`. */
  look(state: Float64Array, node: number, tick: number, held: boolean): void {
    const { box, level } = this.scene;
    const hole = level.blackHole;
    const dx = hole.x - state[0];
    const dy = hole.y - state[1];
    const far = this.distance + hole.radius + box.halfDiagonal;
    if (dx * dx + dy * dy > far * far) return;
    const distance = Math.max(0, boxCircleGap(box, dx, dy, state[4], state[5], hole.radius));
    if (distance >= this.distance) return;
    this.distance = distance;
    this.node = node;
    this.tick = tick;
    this.held = held;
    this.holds = null;
  }

  /**
   * The closest approach. Its holds are derived on demand, because early in a search almost every state is a new minimum; ask
   * before the nodes are discarded.
   */
  closest(nodes: NodeList): Closest | null {
    if (this.node < 0) return null;
    this.holds ??= nodes.holdsTo(this.node, this.tick, this.held);
    return { distance: this.distance, tick: this.tick, holds: this.holds };
  }
}

/** How many runs are kept that press and release in about the same places. */
const ALIKE = 4;

/** The runs found. Each has been replayed from the start, and only a few similar ones are kept. */
export class Reports {
  readonly solutions: Candidate[] = [];
  private readonly replay: Replay;
  private readonly families = new Map<number, number>();
  private readonly scripts = new Set<string>();

  constructor(replay: Replay) {
    this.replay = replay;
  }

  /** Ticks simulated by the replays. */
  get ticks(): number {
    return this.replay.ticks;
  }

  /** Adds the run that passes through node `last` and goes on to tick `until` with the button held or not. */
  add(nodes: NodeList, heat: HeatMap, last: number, until: number, held: boolean): void {
    const family = familyOf(nodes, heat, last, held);
    const members = this.families.get(family) ?? 0;
    if (members >= ALIKE) return;
    if (this.addRun(nodes.holdsTo(last, until, held))) this.families.set(family, members + 1);
  }

  /**
   * Adds a run that is like no other.
   * @param holds [press, release) in ticks
   * @returns whether the run meets the goal and is new
   */
  addRun(holds: readonly Hold[]): boolean {
    const candidate = this.replay.play(holds);
    if (candidate === null) return false;
    // Paths through different cells may have the same holds.
    const script = candidate.holds.join(' ');
    if (this.scripts.has(script)) return false;
    this.scripts.add(script);
    this.solutions.push(candidate);
    return true;
  }
}

/** A hash that is equal for runs that press and release in about the same places. */
function familyOf(nodes: NodeList, heat: HeatMap, last: number, held: boolean): number {
  let family = held ? 1 : 2;
  let button = held;
  for (let n = last; n >= 0; n = nodes.parent[n]) {
    if (nodes.isHeld(n) === button && n !== last) continue;
    button = nodes.isHeld(n);
    family = Math.imul(family ^ heat.districtOf(nodes.square[n]), 0x9e3779b1);
  }
  return family;
}

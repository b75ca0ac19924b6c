import {
  createSimulation,
  joinHolds,
  playScript,
  type Scene,
  type Simulation,
  STATE_SIZE,
  TICK_RATE,
} from '../../engine/index.ts';
import type { Hold } from '../../schema/basics/index.ts';
import { createRandom, type Random } from '../random.ts';
import { cutHolds } from '../verified-run.ts';
import { Approach } from './approach.ts';
import { CellKey } from './cell-key.ts';
import type { SearchTask } from './cell-search.ts';
import { CellTable } from './cell-table.ts';
import { HeatMap } from './heat-map.ts';
import { LineOfFlight } from './line-of-flight.ts';
import { MineralSet } from './mineral-set.ts';
import { NodeList } from './node-list.ts';
import type { Reports } from './reports.ts';
import type { Closest, Effort } from './search.ts';
import { SnapshotPool } from './snapshot-pool.ts';
import { STAGES, type Stages } from './stages.ts';

/** Doubles that all snapshots may take (48 MB). When they are full, the search restarts with other random numbers. */
const MEMORY = 6_000_000;

/** It also restarts after so many nodes. */
const MOST_NODES = 1_000_000;

/** Side of a cell of arrivals at first, px and px/s; they shrink by the factor when a stage has been tried thoroughly. */
const CELL_PLACE = 16;
const CELL_SPEED = 8;
const SHRINK = 0.7;
const FINEST = 8;

/** The cells of a stage shrink when so many attempts have been made from each of its arrivals, on average. */
const THOROUGH = 40;

/** The longest stretches of an attempt, ticks. */
const LONGEST_DRIFT = 600;
const LONGEST_HOLD = 400;
const SHORT_HOLD = 240;

/** Ticks between two looks along the line of flight, in a hold. */
const LOOK = 3;

/** The most px between two looks in a drift. */
const STEP = 12;

/** The share of attempts that begin with other presses before the one that is swept. */
const PREFIX_SHARE = 0.4;

/** How many arrivals are drawn at random to choose the least tried one of them. */
const CANDIDATES = 6;

/** The effort of the n-th stage, from 0, is in proportion to 1 / (ORDER + n). */
const ORDER = 2;

/** So many sets of equally many minerals are told apart. */
const SETS = 1000;

/** Golden ratio: its multiples, modulo 1, fill an interval evenly however many there are. */
const GOLDEN = 0.6180339887498949;

/** An arrival: the state in which she first came into a stage on an attempt. */
interface Arrival {
  readonly node: number;
  readonly snapshot: number;
  tries: number;
  spent: number;
  /** Ticks that she can drift from here; 0 until that has been tried. */
  drift: number;
}

interface Stage {
  readonly id: number;
  readonly arrivals: Arrival[];
  spent: number;
  tries: number;
  refined: number;
}

/**
 * Searches for runs from border to border, as in a relay race. A border is where another asteroid becomes the nearest
 * ({@link Stages}).
 *
 * - An attempt begins with an arrival, a state in which she has just crossed a border. She drifts, sometimes presses at random, and
 *   then holds. During the hold a release is tried wherever a straight line leads across the next border, at a place and velocity that
 *   are new there. What crosses it becomes an arrival of the next stage.
 * - Only arrivals are kept, in cells of place and velocity that are much finer than those of {@link CellSearch}: they form a surface,
 *   not a space, so there are few of them. That matters where only the exact angle at one door leads through the next one.
 * - Stages share the effort, those near the goal get more. Within a stage the least tried of a few arrivals comes first, as an
 *   expansive-space tree grows where it has grown least (D. Hsu et al., 1997).
 */
export class RelaySearch {
  readonly heat: HeatMap;
  private readonly scene: Scene;
  private readonly simulation: Simulation;
  private readonly reports: Reports;
  private readonly stages: Stages;
  private readonly random: Random;
  private readonly needed: number;
  private readonly maxTicks: number;
  private readonly start: Float64Array;
  private readonly scratch: Float64Array;
  private readonly pool: SnapshotPool;
  private readonly capacity: number;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly ahead = new Float64Array(STATE_SIZE);
  private readonly line: LineOfFlight;
  private readonly minerals: MineralSet;
  private readonly key: CellKey;
  private readonly cells = new CellTable();
  private readonly approach: Approach;
  private readonly sets = new Map<number, number>();
  /** By how much is still to be done, least first. */
  private order: Stage[] = [];
  private readonly byId = new Map<number, Stage>();
  private nodes: NodeList;
  /** The holds before the search begins. */
  private readonly lead: readonly Hold[];
  private stored = 0;
  private runs = 0;
  private ticks = 0;
  private last = 0;
  /** The stage that this attempt has to beat. */
  private lowest = 0;

  constructor({ scene, needed, maxTicks, after, reports }: SearchTask, seed: number, stages: Stages) {
    this.scene = scene;
    this.simulation = createSimulation(scene);
    this.needed = needed;
    this.maxTicks = maxTicks;
    this.reports = reports;
    this.stages = stages;
    this.random = createRandom(seed);
    const { holds, tick } = after ?? { holds: [], tick: 0 };
    this.lead = tick === 0 ? [] : cutHolds(joinHolds(holds), tick - 1);
    this.nodes = new NodeList(this.lead);
    playScript(this.simulation, this.lead, tick);
    this.start = this.simulation.snapshot();
    this.scratch = this.simulation.snapshot();
    this.pool = new SnapshotPool(this.start.length);
    this.capacity = Math.max(2, Math.floor(MEMORY / this.start.length));
    this.approach = new Approach(scene);
    this.line = new LineOfFlight(scene);
    this.minerals = new MineralSet(scene, needed);
    this.key = new CellKey(scene);
    this.heat = new HeatMap(scene.level.astronaut.x, scene.level.astronaut.y);
    this.restart();
  }

  get effort(): Effort {
    return { runs: this.runs, ticks: this.ticks };
  }

  get closest(): Closest | null {
    return this.approach.closest(this.nodes);
  }

  /** The last tick at which she was seen alive. */
  get latest(): number {
    return this.last;
  }

  private restart(): void {
    this.approach.closest(this.nodes);
    this.cells.clear();
    this.nodes = new NodeList(this.lead);
    this.order = [];
    this.byId.clear();
    this.stored = 0;
    this.simulation.restore(this.start);
    this.minerals.read(this.simulation);
    this.look();
    if (this.simulation.ending !== null) return;
    this.arrive(this.nodes.add(-1, this.simulation.tick, false, this.square(), this.minerals.size, 0), this.stageNow());
  }

  /** Makes one attempt. Returns false when there is nothing to try. */
  step(): boolean {
    if (this.order.length === 0) return false;
    if (this.stored >= this.capacity || this.nodes.count >= MOST_NODES) this.restart();
    const stage = this.least();
    const arrival = this.choose(stage);
    const before = this.ticks;
    this.attempt(arrival, stage.id);
    // at least one tick, so that a search with nowhere to go still ends
    this.ticks = Math.max(this.ticks, before + 1);
    const spent = this.ticks - before;
    arrival.spent += spent;
    arrival.tries++;
    stage.spent += spent;
    stage.tries++;
    if (stage.tries > THOROUGH * stage.arrivals.length && stage.refined < FINEST) {
      stage.refined++;
      stage.tries = 0;
    }
    return true;
  }

  /** The stage that has had the least of its share of the effort. */
  private least(): Stage {
    let best = this.order[0];
    let least = Number.POSITIVE_INFINITY;
    for (let n = 0; n < this.order.length; n++) {
      const spent = this.order[n].spent * (ORDER + n);
      if (spent >= least) continue;
      best = this.order[n];
      least = spent;
    }
    return best;
  }

  private choose({ arrivals }: Stage): Arrival {
    let best = arrivals[this.random.below(arrivals.length)];
    for (let i = 1; i < CANDIDATES; i++) {
      const other = arrivals[this.random.below(arrivals.length)];
      if (other.spent < best.spent) best = other;
    }
    return best;
  }

  /** Simulates one attempt from an arrival. The first one from each drifts as long as it can. */
  private attempt(arrival: Arrival, stage: number): void {
    const { simulation, random, minerals } = this;
    simulation.restore(this.pool.at(arrival.snapshot));
    minerals.read(simulation);
    this.look();
    this.lowest = stage;
    this.runs++;
    let { node } = arrival;
    if (arrival.tries === 0) {
      const from = simulation.tick;
      this.coast(node, LONGEST_DRIFT);
      arrival.drift = Math.max(1, simulation.tick - from);
      return;
    }
    let drift = Math.floor(((arrival.tries * GOLDEN) % 1) * arrival.drift);
    if (random.unit() < PREFIX_SHARE) {
      const presses = 1 + random.below(2);
      for (let i = 0; i < presses && node >= 0; i++) {
        node = this.coast(node, i === 0 ? drift : Math.floor(random.unit() * random.unit() * LONGEST_DRIFT * 0.4));
        if (node >= 0) node = this.hold(node, 1 + Math.floor(random.unit() * random.unit() * SHORT_HOLD), false);
      }
      drift = Math.floor(random.unit() * random.unit() * LONGEST_DRIFT * 0.4);
    }
    if (node >= 0 && drift > 0) node = this.coast(node, drift);
    if (node >= 0) this.hold(node, LONGEST_HOLD, true);
  }

  /** Drifts for some ticks. Returns the node at the end, or -1 if the run is over. */
  private coast(from: number, ticks: number): number {
    const { simulation, state } = this;
    const until = Math.min(this.maxTicks, simulation.tick + ticks);
    let node = from;
    while (simulation.tick < until) {
      const speed = Math.sqrt(state[2] * state[2] + state[3] * state[3]);
      const stride = Math.floor((TICK_RATE * STEP) / speed) + 1;
      this.ticks += simulation.advance(Math.min(stride, 60, until - simulation.tick), false);
      node = this.passed(node, false);
      if (node < 0) return -1;
    }
    return simulation.tick < this.maxTicks ? this.nodeNow(node, false) : -1;
  }

  /** Holds for some ticks, and tries releases on the way. */
  private hold(from: number, ticks: number, probing: boolean): number {
    const { simulation, state, minerals, line } = this;
    const until = Math.min(this.maxTicks, simulation.tick + ticks);
    const hole = this.scene.level.blackHole;
    let node = from;
    let hit = false;
    while (simulation.tick < until) {
      this.ticks += simulation.advance(Math.min(LOOK, until - simulation.tick), true);
      node = this.passed(node, true);
      if (node < 0) return -1;
      if (!probing) continue;
      line.from(state);
      const distance = minerals.size >= this.needed ? line.distanceTo(hole.x, hole.y, hole.radius) : -1;
      if (distance >= 0 && line.ticksFor(distance) < LONGEST_DRIFT && line.isClear(distance)) {
        if (!hit) this.release(node, Math.ceil(line.ticksFor(distance)) + 30);
        hit = true;
        continue;
      }
      hit = false;
      const flight = this.flightToBorder();
      if (flight > 0) this.release(node, flight);
    }
    return simulation.tick < this.maxTicks ? this.nodeNow(node, true) : -1;
  }

  /** Tries a release now. */
  private release(node: number, ticks: number): void {
    const { simulation, scratch, lowest, minerals } = this;
    simulation.snapshot(scratch);
    this.runs++;
    this.coast(this.nodeNow(node, true), ticks);
    simulation.restore(scratch);
    minerals.read(simulation);
    this.look();
    this.lowest = lowest;
  }

  /**
   * Ticks until a release now would carry her, on a straight line, over a border that leads on; 0 if it would not, or into a cell
   * that is known.
   */
  private flightToBorder(): number {
    const { stages, state, minerals, line, ahead } = this;
    const { map } = stages;
    const speed = Math.sqrt(state[2] * state[2] + state[3] * state[3]);
    if (!(speed > 1)) return 0;
    const { missing } = minerals;
    const here = stages.at(state[0], state[1], missing);
    const base = this.stageNow() - here;
    // nothing is lower than stage 0
    if (base >= this.lowest) return 0;
    const step = map.size;
    const ux = (state[2] / speed) * step;
    const uy = (state[3] / speed) * step;
    const most = Math.floor((speed * LONGEST_DRIFT) / TICK_RATE / step);
    let x = state[0];
    let y = state[1];
    for (let i = 1; i <= most; i++) {
      x += ux;
      y += uy;
      const square = map.squareAt(x, y);
      if (!map.isFree(square)) return 0;
      const stage = stages.ofSquare(square, missing);
      if (base + stage >= this.lowest) continue;
      ahead.set(state);
      ahead[0] = x;
      ahead[1] = y;
      if (this.isKnown(ahead, base + stage) || !line.isClear(i * step)) return 0;
      return Math.ceil((i * step * TICK_RATE) / speed) + 2;
    }
    return 0;
  }

  /** Examines the state on a stretch. Returns the last node, or -1 if the run is over. */
  private passed(node: number, held: boolean): number {
    const { simulation, minerals } = this;
    this.look();
    this.approach.look(this.state, node, simulation.tick, held);
    const square = this.square();
    this.heat.visits[square]++;
    const { ending } = simulation;
    this.last = Math.max(this.last, ending?.tick ?? simulation.tick);
    if (ending !== null) {
      if (ending.outcome === 'completed' && minerals.size >= this.needed) this.report(node, simulation.tick, held);
      return -1;
    }
    const stage = this.stageNow();
    if (stage >= this.lowest) return node;
    this.lowest = stage;
    if (this.isKnown(this.state, stage)) return node;
    const arrived = this.nodeNow(node, held);
    this.arrive(arrived, stage);
    return arrived;
  }

  /** The node of this moment on a stretch from `node`. */
  private nodeNow(node: number, held: boolean): number {
    const { tick } = this.simulation;
    return this.nodes.tick[node] === tick ? node : this.nodes.add(node, tick, held, this.square(), this.minerals.size, 0);
  }

  private square(): number {
    return this.heat.squareAt(this.state[0], this.state[1], this.minerals.hash);
  }

  /** Reads the state. */
  private look(): void {
    this.simulation.readState(this.state);
    this.minerals.update(this.simulation);
  }

  private report(node: number, until: number, held: boolean): void {
    const { reports } = this;
    const before = reports.ticks;
    this.runs++;
    reports.add(this.nodes, this.heat, node, until, held);
    this.ticks += reports.ticks - before;
  }

  /** What is still to be done: fewer missing minerals first, then fewer borders. */
  private stageNow(): number {
    const { minerals, state } = this;
    let set = this.sets.get(minerals.collected);
    if (set === undefined) {
      set = this.sets.size % SETS;
      this.sets.set(minerals.collected, set);
    }
    return (
      (Math.max(0, this.needed - minerals.size) * SETS + set) * STAGES + this.stages.at(state[0], state[1], minerals.missing)
    );
  }

  /** Finds the cell of a state that arrives in a stage. Returns whether it has an arrival. */
  private isKnown(state: Float64Array, stage: number): boolean {
    const { key, cells } = this;
    const refined = this.byId.get(stage)?.refined ?? 0;
    let shrink = 1;
    for (let i = 0; i < refined; i++) shrink *= SHRINK;
    key.find(
      this.simulation,
      state,
      CELL_PLACE * shrink,
      CELL_SPEED * shrink,
      Math.imul(stage + 1, 0x85ebca6b) ^ (refined << 24),
    );
    return cells.at(cells.find(key.low, key.high)) >= 0;
  }

  /** Keeps an arrival. */
  private arrive(node: number, id: number): void {
    const { key, cells } = this;
    this.isKnown(this.state, id);
    cells.put(cells.find(key.low, key.high), key.low, key.high, node);
    const stage = this.byId.get(id) ?? this.open(id);
    const snapshot = this.stored++;
    this.simulation.snapshot(this.pool.at(snapshot));
    stage.arrivals.push({ node, snapshot, tries: 0, spent: 0, drift: 0 });
  }

  /** Begins a stage. It gets its share of the effort from now on, and does not have to catch up with the others. */
  private open(id: number): Stage {
    const { order } = this;
    const place = order.findIndex((other) => other.id > id);
    const n = place < 0 ? order.length : place;
    const least = order.reduce((spent, stage, k) => Math.min(spent, stage.spent * (ORDER + k)), Number.POSITIVE_INFINITY);
    const stage: Stage = { id, arrivals: [], spent: order.length === 0 ? 0 : least / (ORDER + n), tries: 0, refined: 0 };
    order.splice(n, 0, stage);
    this.byId.set(id, stage);
    return stage;
  }
}

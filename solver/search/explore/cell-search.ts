import {
  createSimulation,
  joinHolds,
  playScript,
  type Scene,
  type Simulation,
  STATE_SIZE,
  TICK_RATE,
} from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { createRandom, type Random } from '../../random.ts';
import { cutHolds } from '../../verified-run.ts';
import { CellKey, CellTable, MineralSet, SnapshotPool } from './cells.ts';
import { Frontier } from './frontier.ts';
import { BANDS, type Guide } from './guide.ts';
import { HeatMap } from './heat-map.ts';
import { LineOfFlight } from './line-of-flight.ts';
import { Approach, NodeList, type Reports } from './records.ts';
import type { Closest, Effort, Moment } from './search.ts';

// What has been tried from a node.
const PRESSED = 2;
const COASTED = 4;
// Whether a run that ends in a stretch from this node, with the button held or not, has been reported.
const REPORTED_HELD = 8;
const REPORTED_FREE = 16;
const TRIED = PRESSED | COASTED;

/** Doubles that all snapshots may take (96 MB). When they are full, the search restarts with other random numbers. */
const MEMORY = 12_000_000;

// The sizes below were tuned on random levels: half or twice as much costs 10 to 20 % more ticks to the first run.

/** Side of a cell at first, px and px/s. Cells shrink by the factor when everything has been tried. */
const CELL_PLACE = 32;
const CELL_SPEED = 24;
const SHRINK = 0.7;

/** The longest drift to an aim that is considered, ticks. It doubles when cells shrink. */
const PATIENCE = 600;

/** The longest stretches, ticks. Long holds pay off, because she swings to and fro and each swing points somewhere else. */
const LONGEST_HOLD = 600;
const LONGEST_COAST = 1200;

/** The most ticks between two samples of a stretch; fewer where she would fly farther than `STEP` cells. */
const HOLD_STRIDE = 16;
const COAST_STRIDE = 120;
const STEP = 1.1;

/** So many sets of equally many minerals are kept apart. */
const SETS = 1000;

/** A stretch of a guided search counts as this many ticks more, so that states about to end do not get too many. */
const STRETCH = 60;

/** Ticks between two looks along the line of flight, in a hold of a guided search. */
const LOOK = 3;

/** A stretch ends after this many samples in known cells. */
const FAMILIAR_HOLD = 15;
const FAMILIAR_COAST = 3;

/** A path takes over a cell if its tick plus `EARLIER` is at most `EARLIER_PART` of the known path's tick. */
const EARLIER = 60;
const EARLIER_PART = 0.8;

/** How many nodes are drawn at random to choose one of them. */
const CANDIDATES = 10;

/** Share of stretches with the button held: those are the ones that find runs. */
const PRESS_SHARE = 0.85;

/** Share of choices that prefer nodes with more minerals, where the goal requires minerals. */
const RICH_SHARE = 0.5;

/** A node at this tick is half as good a choice as one at the start. */
const FAR_TICKS = 300;

/** What the lanes of a search have in common. */
export interface SearchTask {
  readonly scene: Scene;
  /** How many minerals a run has to collect. */
  readonly needed: number;
  /** The longest a run may last, ticks. */
  readonly maxTicks: number;
  /** Where the search begins; null: at the start of the level. */
  readonly after: Moment | null;
  readonly reports: Reports;
}

/**
 * Searches for runs by exploration, in the manner of Go-Explore (A. Ecoffet et al., 2019).
 *
 * - An archive divides the states (place, velocity, chasers, collected minerals) into cells. For each cell it keeps the earliest
 *   path into it, with a snapshot of the engine, so that any path continues without replaying its beginning.
 * - Each step picks a rarely visited cell, holds or releases the button for a while from its snapshot, and samples the states
 *   on the way. Sampling follows her speed, so that no cell is jumped over. States in new cells are stored.
 * - During every hold the search asks whether a release now would bring her into the black hole. It first tests a straight line
 *   against circles ({@link LineOfFlight}) and simulates only what passes.
 * - When everything has been tried, cells shrink and all nodes are tried again.
 * - With a {@link Guide}, nodes are divided into strata by how far they have to go, the nearest first. Each stratum has its share of
 *   the effort and cells of its own size, and during holds a release is tried where a straight line leads through a door.
 *
 * The search may guess and cut corners, because {@link Reports} replays every run from the start before it is reported.
 */
export class CellSearch {
  readonly heat: HeatMap;
  private readonly scene: Scene;
  private readonly simulation: Simulation;
  private readonly reports: Reports;
  private readonly guide: Guide | null;
  private readonly random: Random;
  private readonly needed: number;
  private readonly maxTicks: number;
  private readonly start: Float64Array;
  private readonly scratch: Float64Array;
  private readonly pool: SnapshotPool;
  private readonly capacity: number;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly line: LineOfFlight;
  private readonly minerals: MineralSet;
  private readonly key: CellKey;
  private readonly cells = new CellTable();
  private readonly frontier = new Frontier();
  private readonly toCoastFirst: number[] = [];
  /** The holds before the search begins. */
  private readonly lead: readonly Hold[];
  private nodes: NodeList;
  private last = 0;
  private runs = 0;
  private ticks = 0;
  private place = CELL_PLACE;
  private speed = CELL_SPEED;
  private patience = PATIENCE;
  private refined = 0;
  /** The part of the frontier that the last cell belongs to. */
  private stratum = 0;
  /** The lowest band reached on this stretch, or ahead of it. */
  private lowest = 0;
  /** Numbers of the sets of minerals seen so far. */
  private readonly sets = new Map<number, number>();
  private readonly approach: Approach;

  /** @param guide by what the frontier is divided; null for a search that prefers no place */
  constructor({ scene, needed, maxTicks, after, reports }: SearchTask, seed: number, guide: Guide | null) {
    this.scene = scene;
    this.simulation = createSimulation(scene);
    this.needed = needed;
    this.maxTicks = maxTicks;
    this.reports = reports;
    this.guide = guide;
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
    this.minerals = new MineralSet(scene, this.needed);
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

  get exhausted(): boolean {
    return this.nodes.count === 0;
  }

  /** The last tick at which she was seen alive. */
  get latest(): number {
    return this.last;
  }

  /** Some of the states that are kept, at most `count`, evenly spread over the order in which they were found. */
  moments(count: number): Moment[] {
    const { nodes } = this;
    const step = Math.max(1, nodes.count / count);
    return Array.from({ length: Math.min(count, nodes.count) }, (_, i): Moment => {
      const node = Math.floor(i * step);
      return { holds: nodes.holdsTo(node, nodes.tick[node], false), tick: nodes.tick[node] };
    });
  }

  private restart(): void {
    this.approach.closest(this.nodes);
    this.cells.clear();
    this.nodes = new NodeList(this.lead);
    this.frontier.clear();
    this.toCoastFirst.length = 0;
    this.simulation.restore(this.start);
    this.minerals.read(this.simulation);
    this.simulation.readState(this.state);
    if (this.needed > this.scene.minerals.count || this.simulation.ending !== null) return;
    this.last = Math.max(this.last, this.simulation.tick);
    this.findCell();
    // Try first what happens without any press.
    this.toCoastFirst.push(this.store(-1, false, this.visit()));
  }

  /** Simulates one stretch from one node. Returns false when there is nothing to try. */
  step(): boolean {
    const { nodes } = this;
    if (nodes.count === 0) return false;
    if (nodes.count >= this.capacity) this.restart();
    const first = this.toCoastFirst.pop();
    if (first !== undefined) {
      this.explore(first, false);
      return true;
    }
    const stratum = this.frontier.least();
    let held = this.random.unit() < PRESS_SHARE;
    let node = this.select(stratum, held);
    if (node < 0) {
      held = !held;
      node = this.select(stratum, held);
    }
    if (node < 0) this.refine(stratum);
    else this.explore(node, held);
    return true;
  }

  private explore(node: number, held: boolean): void {
    const before = this.ticks;
    this.sweep(node, held);
    this.frontier.spend(this.nodes.stratum[node], this.ticks - before + STRETCH);
  }

  /** Picks a node from which this has not been tried: of a few at random, the one in the least visited square. */
  private select(stratum: number, held: boolean): number {
    const { nodes, heat } = this;
    const tried = held ? PRESSED : COASTED;
    const rich = this.needed > 0 && this.random.unit() < RICH_SHARE;
    const score = (node: number): number => {
      if ((nodes.flags[node] & tried) !== 0) return Number.POSITIVE_INFINITY;
      const tick = nodes.tick[node];
      const h = heat.visits[nodes.square[node]] * (tick + FAR_TICKS);
      return rich ? h - 1e10 * nodes.minerals[node] : h;
    };
    return this.frontier.take(stratum, held, this.random, CANDIDATES, score);
  }

  /** Simulates a stretch from a node with the button held or not, and stores the new states on the way. */
  private sweep(node: number, held: boolean): void {
    const { simulation, state, minerals, nodes, needed } = this;
    nodes.flags[node] |= held ? PRESSED : COASTED;
    simulation.restore(this.pool.at(node));
    minerals.read(simulation);
    simulation.readState(state);
    this.runs++;
    const known = held ? FAMILIAR_HOLD : FAMILIAR_COAST;
    const until = Math.min(this.maxTicks, simulation.tick + (held ? LONGEST_HOLD : LONGEST_COAST));
    let last = node;
    let familiar = 0;
    let crossBefore = 0;
    let dotBefore = 0;
    let hit = false;
    let aimed = 0;
    if (this.guide !== null) this.findCell();
    this.lowest = this.bandNow();
    while (simulation.tick < until) {
      const stride = this.strideFor(held, until - simulation.tick);
      if (held && this.guide !== null) last = this.holdOn(this.guide, simulation.tick + stride, last);
      else this.ticks += simulation.advance(stride, held);
      simulation.readState(state);
      minerals.update(simulation);
      const square = this.visit();
      this.approach.look(state, last, simulation.tick, held);
      const { ending } = simulation;
      this.last = Math.max(this.last, ending?.tick ?? simulation.tick);
      if (ending !== null) {
        if (ending.outcome === 'completed' && minerals.size >= needed) this.report(last, simulation.tick, held);
        return;
      }
      if (held && minerals.size >= needed) {
        const hole = this.scene.level.blackHole;
        const dx = hole.x - state[0];
        const dy = hole.y - state[1];
        const dot = dx * state[2] + dy * state[3];
        const cross = dx * state[3] - dy * state[2];
        const reach = this.scene.box.halfDiagonal + hole.radius;
        if (dot > 0 && cross * cross < reach * reach * (state[2] * state[2] + state[3] * state[3])) {
          if (!hit) hit = this.probe(last);
        } else {
          if (!hit && stride > 1 && (dot > 0 || dotBefore > 0) && cross * crossBefore < 0) this.probeBetween(last, stride);
          hit = false;
        }
        crossBefore = cross;
        dotBefore = dot;
      }
      let stored = -1;
      if (this.isBetter()) {
        stored = this.store(last, held, square);
        nodes.flags[last] |= held ? PRESSED : COASTED;
        last = stored;
        familiar = 0;
      } else if (++familiar > known) return;
      if (held && minerals.size < needed) {
        const aims = this.mineralsAhead() & ~aimed;
        if (aims !== 0) {
          aimed |= aims;
          if (stored < 0) {
            stored = this.store(last, held, square);
            nodes.flags[last] |= held ? PRESSED : COASTED;
            last = stored;
          }
          this.toCoastFirst.push(stored);
        }
      }
      // She is so slow that waiting longer shows nothing new.
      if (!held && stride === COAST_STRIDE) return;
    }
  }

  /**
   * Holds on until a tick, and asks on the way whether a release would carry her through the next door, on a straight line into a
   * lower band than any before on this stretch. Drifts that would are simulated first.
   * @returns the last node on the stretch
   */
  private holdOn(guide: Guide, until: number, last: number): number {
    const { simulation, state, minerals, nodes, line } = this;
    let node = last;
    while (simulation.tick < until && simulation.ending === null) {
      this.ticks += simulation.advance(Math.min(LOOK, until - simulation.tick), true);
      if (simulation.ending !== null) break;
      simulation.readState(state);
      minerals.update(simulation);
      const band = guide.bandAhead(state, minerals.missing, this.lowest, line);
      if (band >= this.lowest) continue;
      this.lowest = band;
      this.findCell();
      nodes.flags[node] |= PRESSED;
      node = this.store(node, true, this.visit());
      this.toCoastFirst.push(node);
    }
    return node;
  }

  /** How far she still has to go. */
  private bandNow(): number {
    const { guide, state } = this;
    return guide === null ? 0 : guide.bandAt(state[0], state[1], this.minerals.missing);
  }

  /** The part of the frontier that the state belongs to: those with fewer missing minerals first, then by band. */
  private stratumNow(): number {
    const { guide, minerals } = this;
    if (guide === null) return 0;
    let set = this.sets.get(minerals.collected);
    if (set === undefined) {
      set = this.sets.size % SETS;
      this.sets.set(minerals.collected, set);
    }
    return (Math.max(0, this.needed - minerals.size) * SETS + set) * BANDS + this.bandNow();
  }

  private strideFor(held: boolean, left: number): number {
    const { state } = this;
    const speed = Math.sqrt(state[2] * state[2] + state[3] * state[3]);
    const most = Math.min(left, held ? HOLD_STRIDE : COAST_STRIDE);
    const stride = Math.floor((TICK_RATE * STEP * this.place) / speed) + 1;
    return stride < most ? stride : most;
  }

  /** The minerals (one bit per index) that she would meet if the button were released now. */
  private mineralsAhead(): number {
    const { simulation, state, line } = this;
    const { halfDiagonal } = this.scene.box;
    const { x, y, r } = this.scene.minerals;
    const speedSquared = state[2] * state[2] + state[3] * state[3];
    let ahead = 0;
    for (let i = 0; i < this.minerals.aims; i++) {
      if (simulation.isCollected(i)) continue;
      const dx = x[i] - state[0];
      const dy = y[i] - state[1];
      const cross = dx * state[3] - dy * state[2];
      const reach = halfDiagonal + r[i];
      if (!(dx * state[2] + dy * state[3] > 0 && cross * cross < reach * reach * speedSquared)) continue;
      line.from(state);
      const distance = line.distanceTo(x[i], y[i], r[i]);
      if (distance >= 0 && line.ticksFor(distance) < this.patience && line.isClear(distance)) ahead |= 1 << i;
    }
    return ahead;
  }

  /**
   * Tries a release at every tick since the last sample, `stride` ticks ago. The direction of flight has swept across the black
   * hole in between.
   */
  private probeBetween(last: number, stride: number): void {
    const { simulation, state, minerals } = this;
    const end = simulation.tick;
    simulation.restore(this.pool.at(last));
    if (end - stride > simulation.tick) this.ticks += simulation.advance(end - stride - simulation.tick, true);
    let hit = false;
    while (simulation.tick < end) {
      this.ticks += simulation.advance(hit ? end - simulation.tick : 1, true);
      if (simulation.tick >= end) break;
      simulation.readState(state);
      hit = this.probe(last);
    }
    simulation.readState(state);
    minerals.read(simulation);
  }

  /** Whether a release now brings her into the black hole: predicted first, then simulated. */
  private probe(last: number): boolean {
    const { simulation, line, state, minerals } = this;
    const hole = this.scene.level.blackHole;
    line.from(state);
    const distance = line.distanceTo(hole.x, hole.y, hole.radius);
    if (distance < 0) return false;
    const flight = line.ticksFor(distance);
    if (!(flight < this.patience) || !line.isClear(distance)) return false;
    simulation.snapshot(this.scratch);
    const released = simulation.tick;
    this.runs++;
    this.ticks += simulation.advance(Math.min(this.maxTicks - released, Math.ceil(flight) + 30), false);
    minerals.read(simulation);
    const hit = simulation.ending?.outcome === 'completed' && minerals.size >= this.needed;
    if (hit) this.report(last, released, true);
    simulation.restore(this.scratch);
    minerals.read(simulation);
    return hit;
  }

  /**
   * Reports the run through a node that goes on to tick `until` with the button held or not. Each node reports once for either.
   */
  private report(last: number, until: number, held: boolean): void {
    const { nodes, reports } = this;
    const reported = held ? REPORTED_HELD : REPORTED_FREE;
    if ((nodes.flags[last] & reported) !== 0) return;
    nodes.flags[last] |= reported;
    const before = reports.ticks;
    this.runs++;
    reports.add(nodes, this.heat, last, until, held);
    this.ticks += reports.ticks - before;
  }

  /** Everything has been tried in a stratum: shrinks its cells and opens all its nodes again. */
  private refine(stratum: number): void {
    // Without strata all cells shrink, so that none of the old ones is needed.
    if (this.guide === null) this.cells.clear();
    // This counts as work, so that a search with nowhere to go still ends.
    this.ticks++;
    this.frontier.spend(stratum, 1);
    const { nodes, cells, key } = this;
    for (const node of this.frontier.refine(stratum)) {
      nodes.flags[node] &= ~TRIED;
      this.simulation.restore(this.pool.at(node));
      this.simulation.readState(this.state);
      this.minerals.read(this.simulation);
      this.findCell();
      const place = cells.find(key.low, key.high);
      if (cells.at(place) < 0) cells.put(place, key.low, key.high, node);
      this.frontier.add(node, stratum, nodes.tick[node] < this.maxTicks);
    }
  }

  /** Counts a visit of the current place. Returns the number of its square. */
  private visit(): number {
    const { state, heat } = this;
    return heat.visit(state[0], state[1], this.minerals.hash);
  }

  private findCell(): void {
    this.stratum = this.stratumNow();
    const refined = this.frontier.refinedOf(this.stratum);
    if (refined !== this.refined) {
      this.refined = refined;
      this.place = CELL_PLACE;
      this.speed = CELL_SPEED;
      this.patience = PATIENCE;
      for (let i = 0; i < refined; i++) {
        this.place *= SHRINK;
        this.speed *= SHRINK;
        this.patience *= 2;
      }
    }
    const { hash } = this.minerals;
    this.key.find(this.simulation, this.state, this.place, this.speed, this.guide === null ? hash : hash ^ (refined << 24));
  }

  /**
   * Whether the state lies in a new cell, or reaches a known one much earlier than before. In the second case nothing more is
   * tried from the old node.
   */
  private isBetter(): boolean {
    this.findCell();
    const { nodes, cells, key } = this;
    const other = cells.at(cells.find(key.low, key.high));
    if (other < 0) return true;
    if (this.simulation.tick + EARLIER > nodes.tick[other] * EARLIER_PART) return false;
    nodes.flags[other] |= TRIED;
    return true;
  }

  private store(parent: number, held: boolean, square: number): number {
    const { key, cells, simulation } = this;
    const node = this.nodes.add(parent, simulation.tick, held, square, this.minerals.size, this.stratum);
    simulation.snapshot(this.pool.at(node));
    cells.put(cells.find(key.low, key.high), key.low, key.high, node);
    this.frontier.add(node, this.stratum, simulation.tick < this.maxTicks);
    return node;
  }
}

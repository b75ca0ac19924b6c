import { createSimulation, type Scene, type Simulation, STATE_SIZE } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { mirroredShift, type TickNoise, tickNoise } from '../../measure/robustness/index.ts';
import { createRandom, type Random } from '../../random.ts';
import { type Goal, mineralsNeeded } from '../../verified-run.ts';
import type { HeatMap } from '../explore/index.ts';

/** A run that the search has found. */
export interface CloudRun {
  /** [press, release) in ticks. */
  readonly holds: readonly Hold[];
  /** The share of its noisy attempts that met the goal, 0 to 1. */
  readonly share: number;
}

/** Attempts that are simulated together. The first has no noise; the others form pairs with opposite noise. */
const CLOUD = 8;

/** Ticks between the edges that are tried, and the shortest and longest stretch. */
const STRIDE = 8;
const SHORTEST = 6;
const LONGEST = 330;

/** How long a last hold that need not end goes on, ticks. */
const HELD_ON = 400;

/** Doubles that all snapshots may take. */
const MEMORY = 8_000_000;

/** A partial path: its edges, and the state of each attempt at its own, noisy time of the last edge. */
interface NoisyWay {
  readonly edges: readonly number[];
  readonly states: readonly Float64Array[];
  /** The share of attempts that are under way or have met the goal. */
  readonly share: number;
  readonly worth: number;
  /** Whether another path reached the same cell with less loss. */
  outdone: boolean;
}

/**
 * Searches directly for robust runs, instead of measuring the robustness of runs that were found without noise: the state of
 * the search is a small cloud of noisy attempts. Of the paths that reach the same cell, the search keeps the one that loses the
 * fewest attempts.
 */
export class CloudSearch {
  /** Ticks simulated so far, and stretches. */
  ticks = 0;
  runs = 0;
  private readonly scene: Scene;
  private readonly needed: number;
  private readonly maxTicks: number;
  private readonly seed: number;
  private readonly random: Random;
  private readonly noise: TickNoise;
  private readonly cloud: readonly Simulation[];
  private readonly place: number;
  private readonly speed: number;
  /** How many paths are drawn at random to follow the most promising of them. */
  private readonly tournament: number;
  /** The share of lost attempts that one edge is worth in the choice of a path. */
  private readonly edgeCost: number;
  /** A path that keeps a smaller share of its attempts is abandoned. */
  private readonly leastShare: number;
  private readonly mostWays: number;
  private ways = 0;
  private readonly cells = new Map<string, NoisyWay>();
  private readonly open: NoisyWay[] = [];
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly chasers: Float64Array;
  private readonly heat: HeatMap;
  private found: CloudRun[] = [];

  /**
   * @param sigma standard deviation of the noise of each edge, ms
   * @param heat counts the places where attempts come by
   * @param beginning edges that every path begins with, ticks
   */
  constructor(
    scene: Scene,
    goal: Goal,
    maxTicks: number,
    { sigma, seed, heat, beginning }: { sigma: number; seed: number; heat: HeatMap; beginning: readonly number[] },
  ) {
    this.scene = scene;
    this.heat = heat;
    this.needed = mineralsNeeded(goal, scene.minerals.count);
    this.maxTicks = maxTicks;
    this.seed = seed;
    this.noise = tickNoise(sigma);
    this.random = createRandom(seed);
    // Coarse and fine cells, greedy and patient choices find different runs: vary them with the seed.
    this.place = 28 + 4 * this.random.below(10);
    this.speed = 18 + 2 * this.random.below(6);
    this.tournament = 3 + this.random.below(6);
    this.edgeCost = 0.08 + 0.03 * this.random.below(5);
    this.leastShare = 0.25 * (1 + this.random.below(2));
    this.cloud = Array.from({ length: CLOUD }, () => createSimulation(scene));
    this.chasers = new Float64Array(3 * scene.aliens.count);
    const start = this.cloud[0].snapshot();
    this.mostWays = Math.max(16, Math.floor(MEMORY / (CLOUD * start.length)));
    for (const [depth, tick] of beginning.entries()) {
      for (let i = 0; i < CLOUD; i++) this.playTo(i, depth, tick);
    }
    const alive = this.cloud.filter(({ ending }) => ending === null).length;
    if (this.cloud[0].ending !== null) return;
    const states = beginning.length === 0 ? this.cloud.map(() => start) : this.cloud.map((simulation) => simulation.snapshot());
    this.open.push({ edges: beginning, states, share: alive / CLOUD, worth: 1, outdone: false });
  }

  /** True when there is nothing left to follow. */
  get exhausted(): boolean {
    return this.open.length === 0 || this.ways >= this.mostWays;
  }

  /** Removes and returns the runs found since the last call, the most robust first. */
  harvest(): CloudRun[] {
    const found = this.found.sort((a, b) => b.share - a.share || a.holds.length - b.holds.length);
    this.found = [];
    return found;
  }

  /**
   * Extends one path by one stretch, and stores it for every edge at which the stretch may end.
   * @param share paths that keep a smaller share of their attempts are skipped
   */
  step(share: number): void {
    const way = this.select();
    const least = Math.max(share, this.leastShare);
    if (way === null || way.outdone || way.share < share) return;
    const { cloud } = this;
    const depth = way.edges.length;
    const held = depth % 2 === 1;
    const start = depth === 0 ? 0 : way.edges[depth - 1];
    for (let i = 0; i < CLOUD; i++) cloud[i].restore(way.states[i]);
    this.runs += CLOUD;

    let through = 0;
    let tick = depth === 0 ? 0 : start + SHORTEST + this.random.below(STRIDE);
    for (; tick <= Math.min(this.maxTicks, start + LONGEST); tick += STRIDE) {
      through = 0;
      let alive = 0;
      for (let i = 0; i < CLOUD; i++) {
        this.playTo(i, depth, tick);
        if (cloud[i].ending === null) alive++;
        else if (this.meetsGoal(cloud[i])) through++;
      }
      const left = (alive + through) / CLOUD;
      if (alive === 0 || left < least) break;
      this.keep(way, tick, left, held);
    }
    if (through > 0) this.found.push({ holds: toHolds(way.edges, tick), share: through / CLOUD });
  }

  /** Continues an attempt to its own time of an edge. */
  private playTo(execution: number, edge: number, tick: number): void {
    const simulation = this.cloud[execution];
    const until = Math.min(this.maxTicks, tick + this.shift(edge, execution));
    if (simulation.ending === null && until > simulation.tick)
      this.ticks += simulation.advance(until - simulation.tick, edge % 2 === 1);
  }

  private select(): NoisyWay | null {
    const { open, random } = this;
    if (open.length === 0) return null;
    let best = random.below(open.length);
    for (let k = 1; k < this.tournament; k++) {
      const i = random.below(open.length);
      if (this.promise(open[i]) > this.promise(open[best])) best = i;
    }
    const way = open[best];
    open[best] = open[open.length - 1];
    open.pop();
    return way;
  }

  private promise(way: NoisyWay): number {
    return way.share - this.edgeCost * way.edges.length;
  }

  /** The error of an attempt at an edge, ticks. */
  private shift(edge: number, execution: number): number {
    return execution === 0 ? 0 : mirroredShift(this.noise, this.seed, execution, edge);
  }

  private meetsGoal(simulation: Simulation): boolean {
    return simulation.ending?.outcome === 'completed' && this.collected(simulation) >= this.needed;
  }

  private collected(simulation: Simulation): number {
    if (this.needed === 0 || simulation.mineralCount === 0) return 0;
    let count = 0;
    for (let i = 0; i < this.scene.minerals.count; i++) if (simulation.isCollected(i)) count++;
    return count;
  }

  /** Stores the path that changes the button now, unless a better one to this cell is known. */
  private keep(way: NoisyWay, tick: number, share: number, held: boolean): void {
    const { cloud, state } = this;
    let [x, y, vx, vy, square, alive] = [0, 0, 0, 0, 0, 0];
    for (const simulation of cloud) {
      if (simulation.ending !== null) continue;
      simulation.readState(state);
      this.heat.visit(state[0], state[1], 0);
      x += state[0];
      y += state[1];
      vx += state[2];
      vy += state[3];
      square += state[0] * state[0] + state[1] * state[1];
      alive++;
    }
    x /= alive;
    y /= alive;
    const spread = Math.max(0, square / alive - x * x - y * y);
    const cell = this.cellOf(x, y, vx / alive, vy / alive, held);
    // A compact cloud will lose fewer attempts later on.
    const worth = share - 1e-5 * spread - 0.01 * way.edges.length;
    const known = this.cells.get(cell);
    if (known !== undefined) {
      if (worth <= known.worth + 0.02) return;
      known.outdone = true;
    }
    const states = cloud.map((simulation) => simulation.snapshot());
    const next: NoisyWay = { edges: [...way.edges, tick], states, share, worth, outdone: false };
    this.cells.set(cell, next);
    this.open.push(next);
    this.ways++;
  }

  private cellOf(x: number, y: number, vx: number, vy: number, held: boolean): string {
    const { place, speed, chasers } = this;
    const parts = [held ? 1 : 0, Math.floor(x / place), Math.floor(y / place), Math.floor(vx / speed), Math.floor(vy / speed)];
    const nominal = this.cloud[0];
    if (chasers.length > 0) {
      nominal.readAliens(chasers);
      for (const value of chasers) parts.push(Math.floor(value / (2 * place)));
    }
    if (this.needed > 0) for (let i = 0; i < this.scene.minerals.count; i++) parts.push(nominal.isCollected(i) ? 1 : 0);
    return parts.join();
  }
}

function toHolds(edges: readonly number[], until: number): Hold[] {
  const holds: Hold[] = [];
  for (let i = 0; i < edges.length; i += 2) holds.push([edges[i], edges[i + 1] ?? until + HELD_ON]);
  return holds;
}

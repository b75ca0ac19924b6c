import { createSimulation, type Scene, type Simulation, STATE_SIZE } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { type Goal, mineralsNeeded } from '../goal.ts';
import { createRandom, type Random } from '../random.ts';
import { drawShift, type TickNoise, tickNoise, uniformOf } from '../robustness/index.ts';
import type { HeatMap } from '../search/index.ts';

/** A run as the cloud sees it: the share of its noisy executions that met the goal. */
export interface CloudRun {
  readonly holds: readonly Hold[];
  readonly share: number;
}

/** Executions that move together. The first is without noise; of the others two and two are each other's mirror image. */
const CLOUD = 8;

/** Noise of each edge, ms. Less than what runs are judged by: few executions must not all be unlucky. */
const SIGMA = 30;

/** What has lost more of its executions than this is given up. */
const LEAST_SHARE = 0.5;

/** Ticks: between edges that are tried, shortest and longest stretch. */
const STRIDE = 8;
const SHORTEST = 6;
const LONGEST = 330;

/** A last hold that never needed to end lasts this much longer, ticks. */
const HELD_ON = 400;

/** Doubles that snapshots may take. */
const MEMORY = 8_000_000;

/** A way so far: its edges, and where each execution is at its own, noisy time of the last one. */
interface NoisyWay {
  readonly edges: readonly number[];
  readonly states: readonly Float64Array[];
  /** Of the executions, those still under way or through. */
  readonly share: number;
  readonly worth: number;
  /** Another way got to the same place with less loss. */
  outdone: boolean;
}

/**
 * Searches for runs that forgive, instead of searching for runs and asking what they forgive: a small cloud of noisy
 * executions is led through the level, and of ways that lead to the same place the one that loses the fewest is kept.
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
  private readonly noise: TickNoise = tickNoise(SIGMA);
  private readonly cloud: readonly Simulation[];
  private readonly place: number;
  private readonly speed: number;
  /** Ways out of which the most promising is followed. */
  private readonly tournament: number;
  /** An edge costs as much as this share of executions lost, when it is chosen what to follow. */
  private readonly edgeCost: number;
  private readonly mostWays: number;
  private ways = 0;
  private readonly cells = new Map<string, NoisyWay>();
  private readonly open: NoisyWay[] = [];
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly aliens: Float64Array;
  private readonly heat: HeatMap;
  private found: CloudRun[] = [];

  /** @param heat is told where the executions come by */
  constructor(scene: Scene, goal: Goal, maxTicks: number, seed: number, heat: HeatMap) {
    this.scene = scene;
    this.heat = heat;
    this.needed = mineralsNeeded(goal, scene.minerals.count);
    this.maxTicks = maxTicks;
    this.seed = seed;
    this.random = createRandom(seed);
    // a coarse and a fine net, a greedy and a patient search catch different runs
    this.place = 28 + 4 * this.random.below(10);
    this.speed = 18 + 2 * this.random.below(6);
    this.tournament = 3 + this.random.below(6);
    this.edgeCost = 0.08 + 0.03 * this.random.below(5);
    this.cloud = Array.from({ length: CLOUD }, () => createSimulation(scene));
    this.aliens = new Float64Array(3 * scene.aliens.count);
    const start = this.cloud[0].snapshot();
    this.mostWays = Math.max(16, Math.floor(MEMORY / (CLOUD * start.length)));
    if (this.cloud[0].ending === null) {
      this.open.push({ edges: [], states: this.cloud.map(() => start), share: 1, worth: 1, outdone: false });
    }
  }

  /** Nothing is left to follow. */
  get exhausted(): boolean {
    return this.open.length === 0 || this.ways >= this.mostWays;
  }

  /** The runs found since it was last asked, the most forgiving first. */
  harvest(): CloudRun[] {
    const found = this.found.sort((a, b) => b.share - a.share || a.holds.length - b.holds.length);
    this.found = [];
    return found;
  }

  /** Follows one way by one stretch, past every edge that may end it. @param share ways that have lost more are left */
  step(share: number): void {
    const way = this.select();
    const least = Math.max(share, LEAST_SHARE);
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
        const until = Math.min(this.maxTicks, tick + this.shift(depth, i));
        if (cloud[i].ending === null && until > cloud[i].tick) this.ticks += cloud[i].advance(until - cloud[i].tick, held);
        if (cloud[i].ending === null) alive++;
        else if (this.meetsGoal(cloud[i])) through++;
      }
      const left = (alive + through) / CLOUD;
      if (alive === 0 || left < least) break;
      this.keep(way, tick, left, held);
    }
    if (through > 0) this.found.push({ holds: toHolds(way.edges, tick), share: through / CLOUD });
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

  /** By how many ticks an execution misses an edge. */
  private shift(edge: number, execution: number): number {
    if (execution === 0) return 0;
    const late = drawShift(this.noise, uniformOf(this.seed, execution >> 1, edge));
    return execution % 2 === 0 ? late : -late;
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

  /** Keeps the way that changes the button now, unless a better one is known to this place. */
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
    // a cloud that is closer together will lose fewer later on
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
    const { place, speed, aliens } = this;
    const parts = [held ? 1 : 0, Math.floor(x / place), Math.floor(y / place), Math.floor(vx / speed), Math.floor(vy / speed)];
    const nominal = this.cloud[0];
    if (aliens.length > 0) {
      nominal.readAliens(aliens);
      for (const value of aliens) parts.push(Math.floor(value / (2 * place)));
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

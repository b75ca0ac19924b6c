import { boxCircleGap, createSimulation, type Scene, type Simulation, STATE_SIZE } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { holdsOf } from '../../verified-run.ts';

/** Holds that complete the level. */
export interface Completing {
  readonly edges: readonly number[];
  /** So many of the wanted minerals are not collected. */
  readonly missing: number;
  /** How many edges are shifted. */
  readonly shifted: number;
  /** How far the edges are from the given ones, all together, ticks. */
  readonly total: number;
}

/** What is sought. */
interface Sought {
  readonly holds: readonly Hold[];
  readonly wanted: readonly number[];
  readonly until: number;
  readonly within: number;
  readonly prefers: Preference;
}

/** What is smaller: a smaller shift of all edges together, or one of fewer edges. */
type Preference = 'smallest' | 'fewest';

/** A run that failed, and by how much. */
export interface NearMiss {
  readonly edges: readonly number[];
  readonly miss: number;
}

/** What all parts of a search for other times share: the given edges, the probe and the best that was found. */
export class Task {
  readonly probe: Probe;
  /** The given edges. */
  readonly own: readonly number[];
  /** So many of them may be shifted: those that come before the end of the run. */
  readonly count: number;
  best: Completing | null = null;
  private readonly within: number;
  private readonly prefers: Preference;

  constructor(scene: Scene, { holds, wanted, until, within, prefers }: Sought) {
    this.prefers = prefers;
    this.probe = new Probe(scene, wanted, until);
    this.own = holds.flat();
    this.within = within;
    this.count = this.own.filter((edge) => edge < until).length;
  }

  /** Plays a run, and keeps it if it is the best so far. @returns null where the edges are no run within the limits */
  attempt(edges: readonly number[]): Probed | null {
    if (!this.isAllowed(edges)) return null;
    const probed = this.probe.play(edges);
    if (probed.completed) this.keep(edges, probed.missing);
    return probed;
  }

  /** Like {@link attempt}; runs to come have their beginnings in common with this one. */
  compareWith(edges: readonly number[]): Probed {
    const probed = this.probe.compareWith(edges);
    if (probed.completed && this.isAllowed(edges)) this.keep(edges, probed.missing);
    return probed;
  }

  /** Whether these edges would not be better than the best, even with all minerals. */
  isFutile(edges: readonly number[]): boolean {
    return this.best !== null && this.best.missing === 0 && !this.isSmaller(this.standing(edges, 0), this.best);
  }

  private standing(edges: readonly number[], missing: number): Completing {
    const { own } = this;
    return { edges, missing, shifted: edges.filter((edge, i) => edge !== own[i]).length, total: totalShift(edges, own) };
  }

  private isSmaller(a: Completing, b: Completing): boolean {
    if (this.prefers === 'fewest' && a.shifted !== b.shifted) return a.shifted < b.shifted;
    return a.total < b.total;
  }

  private isAllowed(edges: readonly number[]): boolean {
    const { own, within } = this;
    return holdsOf(edges) !== null && edges.every((edge, i) => Math.abs(edge - own[i]) <= within);
  }

  private keep(edges: readonly number[], missing: number): void {
    const found = this.standing([...edges], missing);
    const { best } = this;
    if (best !== null && (missing > best.missing || (missing === best.missing && !this.isSmaller(found, best)))) return;
    this.best = found;
  }
}

/** How one run ended, and by how much it missed. */
interface Probed {
  /** Whether it completes the level, after the start. */
  readonly completed: boolean;
  /** So many of the wanted minerals were not collected. */
  readonly missing: number;
  /**
   * 0 when the level is completed with all wanted minerals. Otherwise the least distances that were seen, px: from her box to the
   * black hole, and to each wanted mineral that she did not collect.
   */
  readonly miss: number;
}

/** A state of the run that others are compared with, and what had been missed by then. */
interface Mark {
  readonly tick: number;
  readonly state: Float64Array;
  readonly gaps: Float64Array;
}

/** ticks between two marks */
const MARKS = 16;

/** A run costs at least so many ticks: a probe is more than its simulation. */
const LEAST_COST = 10;

/** She is looked at whenever she may have flown this far, px. */
const STEP = 6;
/** She is looked at after so many ticks at least. */
const LONGEST_STEP = 12;

/** No distance counts as less, px, as long as something is missed. */
const LEAST_MISS = 1e-3;

/**
 * Plays many runs of one scene that begin alike. What a run has in common with the run of {@link compareWith} is not simulated
 * again.
 */
class Probe {
  ticks = 0;
  runs = 0;
  private readonly scene: Scene;
  private readonly simulation: Simulation;
  private readonly state = new Float64Array(STATE_SIZE);
  /** Least distances seen: to the black hole, and to each wanted mineral, px. */
  private readonly gaps: Float64Array;
  private readonly wanted: readonly number[];
  private readonly until: number;
  private base: readonly number[] = [];
  private marks: Mark[] = [];

  /**
   * @param wanted indices of the minerals that a run should collect
   * @param until a run fails when it lasts longer, ticks
   */
  constructor(scene: Scene, wanted: readonly number[], until: number) {
    this.scene = scene;
    this.wanted = wanted;
    this.until = until;
    this.simulation = createSimulation(scene);
    this.gaps = new Float64Array(1 + wanted.length);
  }

  /** Plays a run with which those to come have their beginnings in common. @param edges ascending */
  compareWith(edges: readonly number[]): Probed {
    this.base = edges;
    this.marks = [];
    return this.run(edges, true);
  }

  /** Plays a run. @param edges ascending */
  play(edges: readonly number[]): Probed {
    return this.run(edges, false);
  }

  private run(edges: readonly number[], marks: boolean): Probed {
    const { simulation, gaps, until } = this;
    const from = marks ? undefined : this.lastMark(this.firstDifference(edges));
    if (from === undefined) {
      simulation.reset();
      gaps.fill(Number.POSITIVE_INFINITY);
      this.look();
    } else {
      simulation.restore(from.state);
      gaps.set(from.gaps);
    }
    const start = simulation.tick;
    let next = edges.findIndex((edge) => edge > simulation.tick);
    if (next < 0) next = edges.length;
    while (simulation.ending === null && simulation.tick < until) {
      const { tick } = simulation;
      if (marks && tick >= MARKS * this.marks.length) {
        this.marks.push({ tick, state: simulation.snapshot(), gaps: gaps.slice() });
      }
      while (next < edges.length && edges[next] <= tick) next++;
      const edge = next < edges.length ? edges[next] : until;
      simulation.advance(Math.min(this.stride(), edge - tick, until - tick), next % 2 === 1);
      this.look();
    }
    this.runs++;
    this.ticks += Math.max(LEAST_COST, simulation.tick - start);
    return this.judged();
  }

  /** The first tick at which the button differs from that of the run to compare with. */
  private firstDifference(edges: readonly number[]): number {
    for (let i = 0; i < edges.length; i++) if (edges[i] !== this.base[i]) return Math.min(edges[i], this.base[i]);
    return this.until;
  }

  private lastMark(tick: number): Mark | undefined {
    let low = 0;
    let high = this.marks.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.marks[middle].tick <= tick) low = middle + 1;
      else high = middle;
    }
    return this.marks[low - 1];
  }

  private stride(): number {
    const { state } = this;
    const speed = Math.sqrt(state[2] * state[2] + state[3] * state[3]);
    return Math.max(1, Math.min(LONGEST_STEP, Math.floor((60 * STEP) / (speed + 1))));
  }

  private look(): void {
    const { simulation, state, gaps, scene, wanted } = this;
    simulation.readState(state);
    const { blackHole, minerals } = scene.level;
    gaps[0] = Math.min(gaps[0], this.gapTo(blackHole.x, blackHole.y, blackHole.radius));
    for (let i = 0; i < wanted.length; i++) {
      const { x, y, radius } = minerals[wanted[i]];
      gaps[i + 1] = Math.min(gaps[i + 1], this.gapTo(x, y, radius));
    }
  }

  private gapTo(x: number, y: number, radius: number): number {
    const { state, scene } = this;
    return boxCircleGap(scene.box, x - state[0], y - state[1], state[4], state[5], radius);
  }

  private judged(): Probed {
    const { simulation, gaps, wanted } = this;
    const { ending } = simulation;
    const completed = ending !== null && ending.outcome === 'completed' && ending.time > 0;
    let miss = completed ? 0 : Math.max(LEAST_MISS, gaps[0]);
    let missing = 0;
    for (let i = 0; i < wanted.length; i++) {
      if (simulation.isCollected(wanted[i])) continue;
      missing++;
      miss += Math.max(LEAST_MISS, gaps[i + 1]);
    }
    return { completed, missing, miss };
  }
}

/** Indices of the edges that are shifted together. */
export type Move = readonly number[];

/**
 * The ways in which a person would re-time a run: one press or release by itself, a hold as a whole, and everything from one edge
 * on.
 * @param count edges that may be shifted, from the first
 */
export function movesOf(count: number): Move[] {
  const moves: Move[] = [];
  for (let i = 0; i < count; i++) moves.push([i]);
  for (let i = 0; i + 1 < count; i += 2) if (i + 2 < count) moves.push([i, i + 1]);
  for (let i = 0; i + 1 < count; i++) moves.push(Array.from({ length: count - i }, (_, k) => i + k));
  return moves;
}

/** Shifts the edges of a move by so many ticks. */
export function shifted(edges: readonly number[], move: Move, by: number): number[] {
  const moved = [...edges];
  for (const i of move) moved[i] += by;
  return moved;
}

/** How far all edges together are from where they were, ticks. */
const totalShift = (edges: readonly number[], own: readonly number[]): number =>
  edges.reduce((sum, edge, i) => sum + Math.abs(edge - own[i]), 0);

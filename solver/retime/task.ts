import type { Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/basics/index.ts';
import { edgesOf, holdsOf } from '../edges.ts';
import { totalShift } from './moves.ts';
import { Probe, type Probed } from './probe.ts';

/** Holds that complete the level. */
export interface Standing {
  readonly edges: readonly number[];
  /** So many of the wanted minerals are not collected. */
  readonly missing: number;
  /** How many edges are shifted. */
  readonly shifted: number;
  /** How far the edges are from the given ones, all together, ticks. */
  readonly total: number;
}

/** What is sought. */
export interface Sought {
  readonly holds: readonly Hold[];
  readonly wanted: readonly number[];
  readonly until: number;
  readonly within: number;
  readonly prefers: Preference;
}

/** What is smaller: a smaller shift of all edges together, or one of fewer edges. */
type Preference = 'smallest' | 'fewest';

/** A run that failed, and by how much. */
export interface Point {
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
  best: Standing | null = null;
  private readonly within: number;
  private readonly prefers: Preference;

  constructor(scene: Scene, { holds, wanted, until, within, prefers }: Sought) {
    this.prefers = prefers;
    this.probe = new Probe(scene, wanted, until);
    this.own = edgesOf(holds);
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

  private standing(edges: readonly number[], missing: number): Standing {
    const { own } = this;
    return { edges, missing, shifted: edges.filter((edge, i) => edge !== own[i]).length, total: totalShift(edges, own) };
  }

  private isSmaller(a: Standing, b: Standing): boolean {
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

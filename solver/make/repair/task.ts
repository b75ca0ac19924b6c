import type { Terms } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/basics/index.ts';
import type { Proof } from '../../prove/index.ts';
import type { Candidate } from '../../verified-run.ts';
import { applyChange, type Change, changeSize } from './change.ts';
import { groupOf } from './family.ts';
import { TrialRuns } from './trial-runs.ts';

/** A run to try on changed levels. */
export interface Tried {
  readonly holds: readonly Hold[];
  readonly origin: RunOrigin;
}

interface Wanted {
  readonly count: number;
  readonly seed: number;
  readonly proof: Proof | null;
}

/** What all parts of a repair share: the level, the work done and the proposals. */
export class Task {
  readonly level: Level;
  readonly proof: Proof | null;
  readonly trials: TrialRuns;
  /** A run of the level that completes it as it is. */
  completing: number | null = null;
  private readonly count: number;
  private readonly seed: number;
  private searches = 0;
  /** The smallest proposal of each group. */
  private readonly smallest = new Map<string, Proposal>();

  constructor(level: Level, terms: Terms, { count, seed, proof }: Wanted) {
    this.level = level;
    this.proof = proof;
    this.trials = new TrialRuns(terms);
    this.count = count;
    this.seed = seed;
  }

  /** The seed of the next search. */
  nextSeed(): number {
    return this.seed * 65_536 + this.searches++;
  }

  /** Judges a proposal, and keeps it if it is the smallest of its group so far. */
  offer(change: Change | null, { holds, origin }: Tried): void {
    const group = change === null ? origin.from : groupOf(change);
    const size = change === null ? 0 : changeSize(change);
    const before = this.smallest.get(group);
    if (before !== undefined && !isSmaller(size, origin, before)) return;
    const run = this.trials.verify(change === null ? this.level : applyChange(this.level, change), holds);
    if (run !== null) this.smallest.set(group, { change, size, run, origin });
  }

  /** Only a change that is smaller than this is of use in a group, px. */
  boundOf(group: string): number {
    const own = this.smallest.get(group)?.size ?? Number.POSITIVE_INFINITY;
    const best = this.best();
    return best.length < this.count ? own : Math.min(own, best[this.count - 1].size);
  }

  /** Whether the level needs no change, but only a run. */
  get needsOnlyRun(): boolean {
    return [...this.smallest.values()].some(({ change }) => change === null);
  }

  /** Whether there are as many proposals as wanted. */
  get isFull(): boolean {
    return this.smallest.size >= this.count;
  }

  /** The proposals, the smallest first. */
  best(): Proposal[] {
    return [...this.smallest.values()].sort((a, b) => a.size - b.size).slice(0, this.count);
  }
}

/** Of two runs without a change of the level, the one that is shifted less is smaller. */
function isSmaller(size: number, origin: RunOrigin, before: Proposal): boolean {
  if (origin.from === 'adjusted' && before.origin.from === 'adjusted' && before.change === null) {
    return origin.ticks < before.origin.ticks;
  }
  return size < before.size;
}

/** What makes a level completable: a change of the level, or only a run. A replay from the start has confirmed it. */
export interface Proposal {
  /** The change of the level; null when the level itself stays as it is. */
  readonly change: Change | null;
  /** The size of the change, px, as {@link changeSize} measures it; 0 without a change. */
  readonly size: number;
  /** The run that completes the changed level. */
  readonly run: Candidate;
  /** Where the run comes from. */
  readonly origin: RunOrigin;
}

/** Where the run of a proposal comes from. `from` tells the kinds apart. */
export type RunOrigin =
  | {
      /** It is one of the level's own runs, as it is. */
      readonly from: 'own';
      /** Index of the run in the level's list, from 0. */
      readonly index: number;
    }
  | {
      /** It is one of the level's own runs, with other holds. */
      readonly from: 'adjusted';
      /** Index of the run in the level's list, from 0. */
      readonly index: number;
      /** How far its presses and releases are shifted, ticks, all of them together. */
      readonly ticks: number;
    }
  | {
      /** A search found it. */
      readonly from: 'search';
    };

import type { LevelVerdict, LostMineral, Mended, MendOptions, RunFindings, Softlocks } from '../../check/index.ts';
import type { Attempt, PlayStatistics } from '../../check/plays/index.ts';
import type { RunEnd } from '../../check/words/index.ts';
import type { Outcome, Terms } from '../../engine/index.ts';
import type { PlayVerdict } from '../../game/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type {
  Closest,
  Difficulty,
  EdgeSlack,
  Effort,
  Explored,
  Goal,
  Grade,
  Objective,
  Proof,
  Proposal,
  Retimed,
  Robustness,
  Solution,
  Success,
} from '../../solver/index.ts';
import type { Lattice, MovedObject, Reach, Sample } from './leeway/index.ts';

/** A level to simulate in a job. */
export interface Played {
  readonly level: Level;
  /** Under which the answer has to hold. */
  readonly terms: Terms;
}

/** The requests to a worker, by kind. */
export interface Requests {
  /** Searches for runs within a budget, ms; null: until cancelled or nothing can improve. */
  solve: Played & {
    readonly goal: Goal;
    readonly objective: Objective;
    readonly count: number;
    /** Runs to start from; those that don't meet the goal are skipped. */
    readonly known: readonly (readonly Hold[])[];
    readonly seed: number;
    readonly lane: number;
    readonly budget: number | null;
  };
  /** The robustness of a run. */
  robustness: Played & { readonly holds: readonly Hold[]; readonly goal: Goal };
  /** How far each press and release of a run may slip alone. */
  slack: Played & { readonly holds: readonly Hold[]; readonly goal: Goal };
  /** Her path when one edge slips by its slack. */
  fan: Played & { readonly holds: readonly Hold[]; readonly goal: Goal };
  /** How hard the level is, measured with the best run found within the budget (ms) if none is given. */
  difficulty: Played & { readonly holds: readonly Hold[] | null; readonly goal: Goal; readonly budget: number };
  /** The grade of a level file by its own runs, as `gq difficulty` measures one of many levels, but without a search. */
  grade: { readonly text: string; readonly terms: Terms };
  /**
   * Proves, if possible, that no run reaches the black hole or a mineral. Minerals that some run collects are left out:
   * `collected` lists them; null: the level's runs are simulated to find out. `finer`: how long to go on with ever finer sets, ms;
   * 0 if absent.
   */
  proofs: Played & { readonly collected: readonly number[] | null; readonly finer?: number };
  /** Changes that make the level completable, within a budget, ms. */
  fix: Played & { readonly seed: number; readonly budget: number };
  /** What mends a level that a change has broken. */
  mend: MendOptions;
  /** The findings of all runs of a level. */
  check: Played;
  /** Errors and costs of all settings for this level and run. */
  accuracy: Played & { readonly holds: readonly Hold[] };
  /** A small picture of a level file, and its verdict. */
  thumbnail: {
    readonly text: string;
    readonly terms: Terms;
    readonly width: number;
    readonly theme: 'dark' | 'light';
  };
  /** Two versions of a level file in one picture, and what is true of both. */
  compare: {
    readonly before: string;
    readonly after: string;
    readonly terms: Terms;
    readonly width: number;
    readonly theme: 'dark' | 'light';
  };
  /** Verifies plays of a level, and says what they teach together with those that are known. */
  plays: Played & {
    /** The contents of their `.gqr` files. */
    readonly plays: readonly Uint8Array[];
    /** What plays that were verified before turned out to be. */
    readonly known: readonly Attempt[];
    /** The index of the first of `plays` among all plays. */
    readonly first: number;
  };
  /** Where the level is already lost although she lives on, examined with so much effort, ticks. */
  lost: Played & { readonly effort: number };
  /** Since when runs were lost that do not complete the level, with so much effort for all of them, ticks. */
  losses: Played & { readonly traced: readonly (readonly Hold[])[]; readonly effort: number };
  /** Where objects may stand, moved alike, without these holds ending otherwise. */
  leeway: Played & {
    readonly holds: readonly Hold[];
    readonly objects: readonly MovedObject[];
    /** Index of the only place of each object that moves; null: all of them. */
    readonly only: number | null;
    /** The place of the first of them, which snaps to the grid, px. */
    readonly lead: { readonly x: number; readonly y: number };
    /** px between grid lines; null: objects do not snap to it. */
    readonly grid: number | null;
    /** What is examined: places of the lead, px. */
    readonly seen: { readonly left: number; readonly top: number; readonly right: number; readonly bottom: number };
  };
  /** Small shifts of a run's presses and releases with which it completes the level, with so much effort, ticks. */
  retime: Played & {
    readonly holds: readonly Hold[];
    /** Indices of the minerals to keep. */
    readonly minerals: readonly number[];
    /** Holds that worked a moment ago; null: none. */
    readonly warm: readonly Hold[] | null;
    readonly within: number;
    /** The tick in which the run ended before. */
    readonly formerEnd: number;
    readonly effort: number;
    readonly certifies: boolean;
  };
  /** Her path with these holds, up to a tick. */
  path: Played & { readonly holds: readonly Hold[]; readonly until: number };
  /** Her trajectory with these holds, and how it ends. */
  trajectory: Played & { readonly holds: readonly Hold[] };
}

export type JobKind = keyof Requests;

/** What was found to make a level completable. */
export interface Fixing {
  /** The smallest first. */
  readonly proposals: readonly Proposal[];
  readonly effort: Effort;
  /** Whether the level is proved impossible as it is. */
  readonly isImpossible: boolean;
  /** Index of a run that completes the level as it is; null if none of its own does. */
  readonly completing: number | null;
  /** Whether all was tried; false: the time was over. */
  readonly finished: boolean;
}

/** What was found to mend a level. */
export interface Mending {
  readonly found: readonly Mended[];
  readonly effort: Effort;
  readonly finished: boolean;
}

/** What was found to keep a run alive. */
export interface Retiming {
  /** null: nothing so far */
  readonly best: Retimed | null;
  readonly effort: Effort;
  /** Whether all was tried; false: the effort was spent. */
  readonly finished: boolean;
}

export interface Solving {
  readonly effort: Effort;
  readonly closest: Closest | null;
  /** best first */
  readonly solutions: readonly Solution[];
  readonly explored: Explored;
  readonly finished: boolean;
}

/** Her path when an edge comes earlier or later by its slack. */
export interface FanWay {
  /** 2 i for the press of hold i, 2 i + 1 for its release */
  readonly edge: number;
  /** ticks, negative for earlier */
  readonly shift: number;
  /** x, y in px, every `FAN_TICKS` ticks from the first that differs */
  readonly points: Float32Array;
}

export interface Fan {
  readonly slack: readonly EdgeSlack[];
  readonly ways: readonly FanWay[];
}

/** One setting in a work-precision diagram. */
export interface Setting {
  readonly name: string;
  /** px */
  readonly error: number;
  /** microseconds per simulated second */
  readonly cost: number;
  readonly outcome: Outcome;
  readonly sameVerdict: boolean;
}

/** How it is known that a state is lost: by a proof, or only because no run was found. */
export type LostKnown = 'proved' | 'not found';

/** A state from which the black hole can't be reached any more, as far as is known. */
export interface LostMoment {
  /** px */
  readonly x: number;
  readonly y: number;
  readonly tick: number;
  readonly known: LostKnown;
  /** The reason of the proof; null without one. */
  readonly reason: string | null;
  /** How long the search was that found no run, ticks; null with a proof. */
  readonly searched: number | null;
}

/** A lost state, and the longest that she was seen alive after it, ticks. */
export interface LostState extends LostMoment {
  readonly alive: number;
}

/** Where a level is already lost, as far as it has been examined. */
export interface Losing {
  readonly counts: Softlocks['states'];
  /** Lost states after which she lives on for a second or more. */
  readonly states: readonly LostState[];
  /** Where such states begin, the longest life first. */
  readonly places: readonly LostState[];
  readonly ticks: number;
  readonly finished: boolean;
}

/** Since when a run was lost, as far as is known. */
export interface Loss {
  /** The last tick at which she is alive. */
  readonly last: number;
  readonly completes: boolean;
  /** The last tick at which the black hole is known to be in reach; null if none is known. */
  readonly open: number | null;
  /** The first moment from which no run was found; null if none is known. */
  readonly lost: LostMoment | null;
  /** The first moment that is proved lost; null if none is. */
  readonly proved: LostMoment | null;
}

/** The losses of runs, in the order in which they were asked for. */
export interface Losses {
  readonly losses: readonly Loss[];
  readonly ticks: number;
  readonly finished: boolean;
}

/** Where objects may stand without a run ending otherwise, as far as it was sampled. */
export interface Leeway {
  /** How the run ends where they stand now; null: not known yet. */
  readonly base: Sample | null;
  readonly lattice: Lattice;
  /** Cells of the lattice: `CELL_NUMBERS` numbers each. */
  readonly cells: Int32Array;
  readonly reach: readonly Reach[];
  /** Whether all four directions were examined. */
  readonly isReachKnown: boolean;
  /** px between samples where they agree, and where they do not, at most; 0: there are none. */
  readonly every: number;
  readonly atEdges: number;
  /** Whether no part is left without samples. */
  readonly isCovered: boolean;
  readonly samples: number;
  readonly isFinished: boolean;
}

/** What a play is found to be. */
export interface CheckedPlay {
  readonly verdict: PlayVerdict;
  /** The verdict in words. */
  readonly message: string;
  /** What its holds lead to; null unless the verdict is `ok`. */
  readonly replayed: Attempt | null;
}

/** Two versions of a level, compared. */
export interface Compared {
  /** null: a version can't be drawn. */
  readonly svg: string | null;
  /** What is true of each, in words. */
  readonly before: string;
  readonly after: string;
  /** What follows from the changes, in words. */
  readonly effects: readonly string[];
}

/** What a level has for players. */
export interface LevelFacts {
  /** The effects that players may meet here for the first time. */
  readonly effects: readonly string[];
  /** How long the run lasts that completes it, s; null if none does. */
  readonly seconds: number | null;
  /** Minerals that this run collects, or, if none completes it, the first run. */
  readonly minerals: number;
  readonly mineralCount: number;
}

/** The results of jobs. */
export interface Results {
  solve: Solving;
  robustness: Robustness;
  slack: readonly EdgeSlack[];
  fan: Fan;
  /** null: no run was found to measure */
  difficulty: Difficulty | null;
  /** Confirmed by the separate checker; null and empty: nothing was proved. */
  proofs: { readonly impossible: Proof | null; readonly minerals: readonly LostMineral[] };
  fix: Fixing;
  mend: Mending;
  check: RunFindings;
  accuracy: { readonly settings: readonly Setting[] };
  thumbnail: {
    readonly svg: string;
    readonly verdict: LevelVerdict | 'invalid';
    readonly minerals: number;
    /** What the level has for players; null if it is not valid. */
    readonly facts: LevelFacts | null;
  };
  compare: Compared;
  /** null: none of its runs completes the level */
  grade: Grade | null;
  plays: { readonly plays: readonly CheckedPlay[]; readonly statistics: PlayStatistics };
  lost: Losing;
  losses: Losses;
  leeway: Leeway;
  retime: Retiming;
  /** x, y in px at every tick and at the end */
  path: { readonly points: Float32Array };
  trajectory: {
    /** x, y in px at every tick and at the end */
    readonly points: Float32Array;
    /** The direction of the box's x axis there: cos, sin. */
    readonly turns: Float32Array;
    readonly end: RunEnd;
    /** How many different minerals are collected. */
    readonly minerals: number;
    /** The least distance to a hazard, px; null if there is none. */
    readonly clearance: number | null;
  };
}

/** The intermediate results that jobs report. */
export interface Progresses {
  solve: Solving;
  robustness: { readonly slack: readonly EdgeSlack[]; readonly p40: Success };
  slack: never;
  fan: { readonly slack: readonly EdgeSlack[] };
  difficulty: Solving;
  grade: never;
  proofs: Results['proofs'];
  fix: Fixing;
  mend: Mending;
  check: never;
  accuracy: never;
  thumbnail: never;
  compare: never;
  /** The number of plays that are verified. */
  plays: { readonly done: number };
  lost: Losing;
  losses: Losses;
  leeway: Leeway;
  retime: Retiming;
  path: never;
  trajectory: never;
}

export type ToWorker =
  | { [K in JobKind]: { readonly type: 'start'; readonly job: number; readonly kind: K; readonly request: Requests[K] } }[JobKind]
  | { readonly type: 'cancel'; readonly job: number };

export type FromWorker =
  | { readonly type: 'progress'; readonly job: number; readonly progress: unknown }
  | { readonly type: 'done'; readonly job: number; readonly result: unknown }
  | { readonly type: 'failed'; readonly job: number; readonly message: string }
  | { readonly type: 'cancelled'; readonly job: number };

/** ticks between two points of a fan's path */
export const FAN_TICKS = 3;

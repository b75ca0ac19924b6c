import {
  boxCircleGap,
  compile,
  createSimulation,
  type Ending,
  joinHolds,
  maxTicksOf,
  STATE_SIZE,
  type Terms,
} from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/basics/index.ts';
import { createSearch } from '../../search/explore/index.ts';
import type { Steps } from '../../steps.ts';
import { type Candidate, verifyRun } from '../../verified-run.ts';
import type { Vector } from './change.ts';

/** How near one run comes to the black hole. */
export interface Attempt {
  /** Whether it completes the level, after the start. */
  readonly completed: boolean;
  /** The least distance from her box to the black hole that was seen, px; 0 when she completes the level. */
  readonly miss: number;
  /** From the black hole's centre to hers when she was nearest, px. */
  readonly nearest: Vector;
  /** How it ended; null when it did not end within the ticks allowed. */
  readonly ending: Ending | null;
}

/** A trial costs at least this many ticks, because a level is compiled for it. */
const LEAST_COST = 30;

/** A run that is not over this many ticks after its last release is given up. */
const WAIT = 900;

/** She is looked at whenever she may have flown this far, px. */
const STEP = 6;
const LONGEST_STEP = 12;

/** What a search found. */
export interface Sought {
  /** The holds of a run that completes the level; null if none was found. */
  readonly found: readonly Hold[] | null;
  /** The holds that lead nearest to the black hole; null if nothing was simulated. */
  readonly closest: readonly Hold[] | null;
}

/** Tries runs on changed levels, and counts the ticks that it takes. */
export class TrialRuns {
  ticks = 0;
  runs = 0;
  readonly terms: Terms;
  private readonly maxTicks: number;
  private readonly state = new Float64Array(STATE_SIZE);

  constructor(terms: Terms) {
    this.terms = terms;
    this.maxTicks = maxTicksOf(terms);
  }

  /** Plays a run and looks how near it comes. */
  play(level: Level, holds: readonly Hold[]): Attempt {
    const { state } = this;
    const scene = compile(level, this.terms);
    const simulation = createSimulation(scene);
    const joined = joinHolds(holds);
    const last = joined.length === 0 ? 0 : joined[joined.length - 1][1];
    const until = Math.min(this.maxTicks, last + WAIT);
    const { x, y, radius } = level.blackHole;
    let miss = Number.POSITIVE_INFINITY;
    let nearest: Vector = { x: 0, y: 0 };
    const look = () => {
      simulation.readState(state);
      const gap = boxCircleGap(scene.box, x - state[0], y - state[1], state[4], state[5], radius);
      if (gap >= miss) return;
      miss = gap;
      nearest = { x: state[0] - x, y: state[1] - y };
    };
    look();
    let hold = 0;
    while (simulation.ending === null && simulation.tick < until) {
      while (hold < joined.length && joined[hold][1] <= simulation.tick) hold++;
      const next = joined[hold];
      const isHeld = next !== undefined && next[0] <= simulation.tick;
      const edge = next === undefined ? until : isHeld ? next[1] : next[0];
      const speed = Math.sqrt(state[2] * state[2] + state[3] * state[3]);
      const stride = Math.max(1, Math.min(LONGEST_STEP, Math.floor((60 * STEP) / (speed + 1))));
      simulation.advance(Math.min(stride, edge - simulation.tick, until - simulation.tick), isHeld);
      look();
    }
    this.runs++;
    this.ticks += Math.max(LEAST_COST, simulation.tick);
    const { ending } = simulation;
    const completed = ending?.outcome === 'completed' && ending.time > 0;
    return { completed, miss: completed ? 0 : Math.max(miss, 1e-3), nearest, ending };
  }

  /** Judges a run on a level as `verifyRun` does. A run that is over at the start is none. */
  verify(level: Level, holds: readonly Hold[]): Candidate | null {
    const run = verifyRun(compile(level, this.terms), holds, { minerals: 'any' });
    this.runs++;
    this.ticks += run?.tick ?? this.maxTicks;
    return run === null || run.time === 0 ? null : run;
  }

  /**
   * Searches a level for a run.
   * @param ticks how long, ticks
   * @returns the holds of a run, or null; and the holds that lead nearest to the black hole
   */
  *search(level: Level, seed: number, ticks: number): Steps<Sought> {
    const search = createSearch(compile(level, this.terms), { seed });
    const before = { runs: this.runs, ticks: this.ticks };
    while (search.solutions.length === 0 && search.effort.ticks < ticks && !search.exhausted) {
      search.advance(SLICE);
      this.runs = before.runs + search.effort.runs;
      this.ticks = before.ticks + Math.max(LEAST_COST, search.effort.ticks);
      yield null;
    }
    const found = search.solutions.find(({ time }) => time > 0)?.holds ?? null;
    return { found, closest: search.closest?.holds ?? null };
  }
}

/** Ticks of a search between two breaks. */
const SLICE = 2000;

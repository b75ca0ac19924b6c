import { joinHolds, maxTicksOf, type Scene, TICK_RATE } from '../../engine/index.ts';
import type { Hold } from '../../schema/basics/index.ts';
import { edgesOf, holdsOf } from '../edges.ts';
import {
  BRIEF_CERTIFY_RUNS,
  type Certification,
  certifyInSteps,
  createTrials,
  type EdgeSlack,
  SLACK_LIMIT,
  slackOf,
  type Trials,
} from '../robustness/index.ts';
import type { Effort } from '../search/index.ts';
import type { Steps } from '../steps.ts';
import { type Candidate, verifyRun } from '../verified-run.ts';
import { seek } from './seek.ts';
import { centre, shrink } from './settle.ts';
import { Task } from './task.ts';

/** What {@link createRetime} looks for. */
export interface RetimeOptions {
  /** Indices of the minerals that the run should collect, from 0 in the level's list; none by default. */
  readonly minerals?: readonly number[];
  /** Holds that worked a moment ago, with as many presses as the given ones: the search begins there. */
  readonly warm?: readonly Hold[] | null;
  /** No press or release is shifted farther than this, ticks; 90 by default. */
  readonly within?: number;
  /** The tick in which the run ended before the level was changed: a run that lasts 5 s longer is given up. */
  readonly formerEnd?: number;
  /** Whether the smallest shift of all edges together is preferred, which is so by default, or that of the fewest edges. */
  readonly prefers?: 'smallest' | 'fewest';
  /** Whether edges that could hardly slip are moved to where they can; true by default. */
  readonly centres?: boolean;
  /** Whether all shifts of the result are tried, for its certified ticks; false by default. */
  readonly certifies?: boolean;
}

/** Holds near the given ones that complete the level. A replay from the start has confirmed it. */
export interface Retimed {
  /** The holds, with those that come after the end of the run. */
  readonly holds: readonly Hold[];
  /** The run that they lead to. */
  readonly run: Candidate;
  /** How many presses and releases are shifted. */
  readonly edges: number;
  /** The largest of their shifts, ticks. */
  readonly most: number;
  /** All their shifts together, ticks. */
  readonly total: number;
  /** Indices of the wanted minerals that the run does not collect any more. */
  readonly lost: readonly number[];
  /** The slack of each press and release, with the minerals that the run collects; null until it is measured. */
  readonly slack: readonly EdgeSlack[] | null;
  /** What all shifts at once have shown; null until they are tried. */
  readonly certified: Pick<Certification, 'ticks' | 'exhausted'> | null;
}

/** A search for other times of presses and releases. It can be stopped at any time, and has its best result so far. */
export interface Retime {
  /** The work done so far. */
  readonly effort: Effort;
  /** The best result so far; null if none was found. */
  readonly best: Retimed | null;
  /** True when nothing more is tried. */
  readonly finished: boolean;
  /**
   * Continues the work. The same total gives the same result however it is split into calls.
   * @param ticks how many more ticks to simulate; it may overshoot by a few runs
   */
  advance(ticks: number): void;
}

/** No edge is shifted farther than this by default, ticks: it would be another run. */
export const FARTHEST = 90;

/** A run may last so much longer than before, ticks. */
const LONGER = 5 * TICK_RATE;

/** Certified ticks are sought up to here: a person sees no difference beyond. */
const CERTIFY_LIMIT = 12;

/**
 * Creates a search for small shifts of presses and releases with which a run completes a level that has changed. It simulates
 * nothing before the first call of `advance`.
 *
 * It shifts single presses and releases, whole holds, and everything from one edge on, in growing steps; then two at a time. Of
 * what completes the level, it prefers what keeps the wanted minerals, and then the smallest shift of all edges together. Edges
 * that could then hardly slip are moved to where they can.
 * @param scene the compiled level
 * @param holds the run as it was, [press, release) in ticks
 * @param options the minerals to keep, where to begin, and limits
 * @returns a search at its start
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { createRetime } from 'gravity-quest-toolkit/solver';
 *
 * const retime = createRetime(compile(movedLevel), [[12, 96]]);
 * while (!retime.finished && retime.effort.ticks < 1_000_000) retime.advance(50_000);
 * console.log(retime.best?.holds);
 * ```
 */
export function createRetime(scene: Scene, holds: readonly Hold[], options: RetimeOptions = {}): Retime {
  const longest = maxTicksOf(scene.terms);
  const { minerals = [], warm = null, within = FARTHEST, formerEnd = longest } = options;
  const { prefers = 'smallest', centres = true, certifies = false } = options;
  const given = joinHolds(holds);
  const until = Math.min(longest, formerEnd + LONGER);
  const task = new Task(scene, { holds: given, wanted: minerals, until, within, prefers });
  let best: Retimed | null = null;
  let trials: Trials | null = null;
  const replays = { runs: 0, ticks: 0 };

  const retimed = (edges: readonly number[]): Retimed | null => {
    const script = holdsOf(edges);
    const run = script === null ? null : verifyRun(scene, script);
    replays.runs++;
    replays.ticks += run?.tick ?? longest;
    if (script === null || run === null || run.time === 0) return null;
    const shifts = edges.map((edge, i) => Math.abs(edge - task.own[i])).filter((by) => by > 0);
    const lost = minerals.filter((index) => !run.minerals.includes(index));
    const total = shifts.reduce((sum, by) => sum + by, 0);
    return { holds: script, run, edges: shifts.length, most: Math.max(0, ...shifts), total, lost, slack: null, certified: null };
  };
  /** Takes what the task has found. */
  const take = (edges: readonly number[] | undefined): void => {
    if (edges === undefined || best?.holds.flat().join() === edges.join()) return;
    best = retimed(edges) ?? best;
  };
  function* work(): Steps<void> {
    for (const _ of seek(task, warm === null || warm.length !== given.length ? null : edgesOf(warm))) {
      take(task.best?.edges);
      yield null;
    }
    for (const _ of shrink(task)) yield null;
    take(task.best?.edges);
    yield null;
    if (best === null || !centres) return;
    // what completes the level as it was given stays so
    if (best.total > 0) take(yield* centre(task));
    trials = createTrials(scene, { minerals: best.run.minerals.length });
    const joined = joinHolds(best.holds);
    best = { ...best, slack: yield* slackOf(trials, joined, SLACK_LIMIT) };
    yield null;
    if (!certifies) return;
    const { ticks, exhausted } = yield* certifyInSteps(trials, joined, BRIEF_CERTIFY_RUNS, CERTIFY_LIMIT);
    best = { ...best, certified: { ticks, exhausted } };
  }

  const steps = work();
  let asked = 0;
  let finished = false;
  const effort = (): Effort => ({
    runs: task.probe.runs + replays.runs + (trials?.runs ?? 0),
    ticks: task.probe.ticks + replays.ticks + (trials?.ticks ?? 0),
  });
  return {
    get effort() {
      return effort();
    },
    get best() {
      return best;
    },
    get finished() {
      return finished;
    },
    advance(ticks) {
      asked += ticks;
      while (!finished && effort().ticks < asked) finished = steps.next().done === true;
    },
  };
}

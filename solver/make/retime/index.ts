import { joinHolds, maxTicksOf, type Scene, TICK_RATE } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import {
  BRIEF_CERTIFY_RUNS,
  type Certification,
  certifyInSteps,
  createTrials,
  type EdgeSlack,
  SLACK_LIMIT,
  slackOf,
  type Trials,
} from '../../measure/robustness/index.ts';
import type { Effort } from '../../search/explore/index.ts';
import { advancing, type Steps } from '../../steps.ts';
import { type Candidate, holdsOf, verifyRun } from '../../verified-run.ts';
import { seek } from './seek.ts';
import { type Completing, type Move, movesOf, shifted, Task } from './task.ts';

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
const FARTHEST = 90;

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
    for (const _ of seek(task, warm === null || warm.length !== given.length ? null : warm.flat())) {
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

  const effort = (): Effort => ({
    runs: task.probe.runs + replays.runs + (trials?.runs ?? 0),
    ticks: task.probe.ticks + replays.ticks + (trials?.ticks ?? 0),
  });
  const going = advancing(work(), () => effort().ticks);
  return {
    get effort() {
      return effort();
    },
    get best() {
      return best;
    },
    get finished() {
      return going.finished;
    },
    advance: going.advance,
  };
}

/** An edge that can slip by so many ticks either way is left where it is. */
const ENOUGH = 3;

/** So often all edges are centred, because each changes what the others forgive. */
const ROUNDS = 3;

/** Moves shifted edges back towards the given ones, as far as the run still completes the level with as many minerals. */
function* shrink(task: Task): Steps<void> {
  const { own } = task;
  if (task.best === null) return;
  const moves = movesOf(task.count);
  task.compareWith(task.best.edges);
  yield null;
  for (let more = true; more; ) {
    more = false;
    for (const move of moves) {
      for (const edges of towards(task.best.edges, own, move)) {
        const before: Completing = task.best;
        task.attempt(edges);
        yield null;
        if (task.best === before) continue;
        more = true;
        break;
      }
    }
  }
}

/** The edges with those of a move back where they were, half way back, and one tick back. */
function* towards(edges: readonly number[], own: readonly number[], move: Move): Generator<number[]> {
  const away = edges[move[0]] - own[move[0]];
  if (away === 0) return;
  const steps = new Set([away, Math.trunc(away / 2), Math.sign(away)]);
  for (const by of steps) if (by !== 0) yield shifted(edges, move, -by);
}

/**
 * Moves edges that could hardly slip to where they can slip by {@link ENOUGH} ticks either way, or to the middle of what they can.
 * @returns the edges
 */
function* centre(task: Task): Steps<readonly number[]> {
  const { best } = task;
  if (best === null) return [];
  let edges = best.edges;
  const meets = (tried: readonly number[]): boolean => {
    const probed = task.attempt(tried);
    return probed?.completed === true && probed.missing <= best.missing;
  };
  for (let round = 0; round < ROUNDS; round++) {
    let moved = false;
    for (let i = 0; i < task.count; i++) {
      task.compareWith(edges);
      yield null;
      const slack = { earlier: 0, later: 0 };
      for (const [side, sign] of SIDES) {
        while (slack[side] < 2 * ENOUGH && meets(shifted(edges, [i], sign * (slack[side] + 1)))) {
          slack[side]++;
          yield null;
        }
      }
      const by = centring(slack);
      if (by === 0) continue;
      edges = shifted(edges, [i], by);
      moved = true;
    }
    if (!moved) break;
  }
  return edges;
}

const SIDES = [
  ['earlier', -1],
  ['later', 1],
] as const;

/** By how much an edge with this slack is moved, ticks. */
function centring({ earlier, later }: { readonly earlier: number; readonly later: number }): number {
  const least = Math.min(earlier, later);
  const by = Math.min(ENOUGH - least, Math.floor(Math.abs(later - earlier) / 2));
  return by <= 0 ? 0 : later > earlier ? by : -by;
}

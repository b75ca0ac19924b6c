import { type Accuracy, compile, maxTicksOf, type Terms, TICK, termsOf } from '../../../engine/index.ts';
import type { Level } from '../../../schema/basics/index.ts';
import type { Blocker, LineEnd, Proof, Strip } from '../../prove/index.ts';
import type { Effort } from '../../search/explore/index.ts';
import { advancing, type Steps } from '../../steps.ts';
import { createRetime } from '../retime/index.ts';
import { type ObjectRef, objectAt } from './change.ts';
import { HOLE, hazards, isSame, START } from './family.ts';
import { relax } from './relax.ts';
import { moveHole, revive, touchedBy } from './revive.ts';
import { type Proposal, Task, type Tried } from './task.ts';

/** What {@link createRepair} looks for. */
export interface RepairOptions {
  /** How many proposals of different kinds are wanted; 3 by default. */
  readonly count?: number;
  /** Seed of the searches, a whole number; 0 by default. */
  readonly seed?: number;
  /** The longest a run may last, ticks; that of the terms by default. */
  readonly maxTicks?: number;
  /** A proof that the level cannot be completed. It directs the repair, and saves a search of the level as it is. */
  readonly proof?: Proof | null;
}

/** A search for small changes that make a level completable. It can be stopped at any time, and has its best proposals so far. */
export interface Repair {
  /** The work done so far. */
  readonly effort: Effort;
  /**
   * The best proposals so far, the smallest first: at most `count`, each of another kind. A replay from the start has confirmed
   * each of them.
   */
  readonly proposals: readonly Proposal[];
  /** Index of a run of the level that completes it as it is, so that there is nothing to repair; null if there is none. */
  readonly completing: number | null;
  /** True when nothing more is tried. */
  readonly finished: boolean;
  /**
   * Continues the work. The same total gives the same result however it is split into calls.
   * @param ticks how many more ticks to simulate; the repair may overshoot by one search
   */
  advance(ticks: number): void;
}

/**
 * Creates a search for the smallest change that makes a level completable. It simulates nothing before the first call of
 * `advance`.
 *
 * It changes one thing at a time: a place, a radius, the range, her velocity at the start, or it removes an object. Each change
 * that is found is made smaller as far as the run still completes the level, so it is the smallest that was found along its
 * way, not the smallest that there is.
 * @param level the level, with its runs
 * @param under the terms under which a run has to complete it; or only an accuracy, with the default terms for the rest
 * @param options the number of proposals, the seed and a proof that the level is impossible
 * @returns a repair at its start
 * @example
 * ```ts
 * import { ACCURACIES } from 'gravity-quest-toolkit';
 * import { applyChange, createRepair } from 'gravity-quest-toolkit/solver';
 *
 * const repair = createRepair(level, ACCURACIES.precise);
 * while (!repair.finished && repair.effort.ticks < 5_000_000) repair.advance(50_000);
 * const [best] = repair.proposals;
 * if (best?.change) console.log(best.size, applyChange(level, best.change));
 * ```
 */
export function createRepair(level: Level, under: Accuracy | Terms, options: RepairOptions = {}): Repair {
  const { count = 3, seed = 0, maxTicks = maxTicksOf(termsOf(under)), proof = null } = options;
  const task = new Task(level, { ...termsOf(under), maxTime: maxTicks * TICK }, { count, seed, proof });
  const going = advancing(repairSteps(task), () => task.trials.ticks);
  return {
    get effort() {
      return { runs: task.trials.runs, ticks: task.trials.ticks };
    },
    get proposals() {
      return task.best();
    },
    get completing() {
      return task.completing;
    },
    get finished() {
      return going.finished;
    },
    advance: going.advance,
  };
}

/** So many of the level's own runs are tried: those that come nearest to the black hole. */
const MOST_RUNS = 3;

/** Ticks of the search of the level as it is. With a proof it only shows how near she can come. */
const SEARCH = 600_000;
const SEARCH_WHEN_PROVED = 100_000;

/**
 * The work of a repair, from what changes least to what changes most: nothing, the holds of the level's own runs, the level
 * around these runs, a new run, and the level with a new run.
 */
function* repairSteps(task: Task): Steps<void> {
  const { level, proof, trials } = task;
  for (const [index, { holds }] of level.runs.entries()) {
    if (proof === null && trials.verify(level, holds) !== null) {
      task.completing = index;
      return;
    }
    yield null;
  }
  const own = level.runs
    .map(({ holds }, index) => ({ index, miss: trials.play(level, holds).miss }))
    .sort((a, b) => a.miss - b.miss)
    .slice(0, MOST_RUNS);
  if (proof === null) for (const { index } of own) yield* adjustRun(task, index);
  for (const { index } of own) yield* revive(task, { holds: level.runs[index].holds, origin: { from: 'own', index } });
  if (task.needsOnlyRun) return;

  const { found, closest } = yield* trials.search(level, task.nextSeed(), proof === null ? SEARCH : SEARCH_WHEN_PROVED);
  if (found !== null) {
    task.offer(null, { holds: found, origin: { from: 'search' } });
    if (task.needsOnlyRun) return;
  }
  const suspects: ObjectRef[] = proof === null ? [] : suspectsOf(level, proof);
  if (closest !== null) {
    const tried: Tried = { holds: closest, origin: { from: 'search' } };
    const attempt = trials.play(level, closest);
    yield* moveHole(task, tried, attempt);
    const touched = touchedBy(attempt);
    if (touched !== null && proof === null) suspects.push(touched);
  }
  yield* relax(task, suspects);
}

/**
 * The objects that a proof's certificate names as what stands in the way, or that its reason is about. A change of one of them
 * is the most likely to make the level completable.
 */
function suspectsOf(level: Level, { certificate }: Proof): ObjectRef[] {
  switch (certificate.kind) {
    case 'nothing-in-range':
      return [START, ...byDistance(level, level.astronaut)];
    case 'starts-in-hazard':
      return [certificate.hazard, START];
    case 'out-of-range':
      return [HOLE, START];
    case 'covered':
      return [...hazards(level).filter((object) => overlapsHole(level, object)), HOLE];
    case 'enclosed':
      return unique(certificate.barrier.map(({ by }) => by));
    case 'line-trap':
      return [...unique([certificate.front.by, certificate.back.by]), START, { kind: 'asteroid', index: certificate.target }];
    case 'flowpipe': {
      const strips = certificate.layers.flatMap((layer) =>
        layer.flatMap((steps) => steps.flatMap(({ parts }) => parts.flatMap(({ off }): Strip[] => [...off]))),
      );
      return [...unique(strips.map(({ by }) => by)), START];
    }
    case 'doomed':
    case 'orbits':
      return [START];
  }
}

function unique(blockers: readonly (Blocker | LineEnd['by'])[]): ObjectRef[] {
  const found: ObjectRef[] = [];
  for (const blocker of blockers) {
    if (!('index' in blocker)) continue;
    const object: ObjectRef = { kind: blocker.kind, index: blocker.index };
    if (!found.some((other) => isSame(other, object))) found.push(object);
  }
  return found;
}

function byDistance({ asteroids }: Level, { x, y }: { readonly x: number; readonly y: number }): ObjectRef[] {
  const square = (i: number) => (asteroids[i].x - x) * (asteroids[i].x - x) + (asteroids[i].y - y) * (asteroids[i].y - y);
  return [...asteroids.keys()].sort((a, b) => square(a) - square(b)).map((index) => ({ kind: 'asteroid', index }));
}

function overlapsHole(level: Level, object: ObjectRef): boolean {
  const { x, y, radius } = objectAt(level, object);
  const { blackHole } = level;
  const reach = radius + blackHole.radius;
  return (x - blackHole.x) * (x - blackHole.x) + (y - blackHole.y) * (y - blackHole.y) < reach * reach;
}

/** At most this many ticks are simulated for one run. */
const MOST_TICKS = 200_000;

/** Ticks between two breaks. */
const SLICE = 2000;

/**
 * Seeks small shifts of the presses and releases of one of the level's own runs with which it completes the level as it is, and
 * offers the smallest that it finds.
 */
function* adjustRun(task: Task, index: number): Steps<void> {
  const { level, trials } = task;
  const { holds } = level.runs[index];
  if (holds.length === 0) return;
  const retime = createRetime(compile(level, trials.terms), holds, { centres: false });
  const before = { runs: trials.runs, ticks: trials.ticks };
  while (!retime.finished && retime.effort.ticks < MOST_TICKS) {
    retime.advance(SLICE);
    trials.runs = before.runs + retime.effort.runs;
    trials.ticks = before.ticks + retime.effort.ticks;
    yield null;
  }
  const { best } = retime;
  if (best !== null) task.offer(null, { holds: best.holds, origin: { from: 'adjusted', index, ticks: best.total } });
}

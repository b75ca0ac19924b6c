import { compile, joinHolds, type Terms } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import {
  applyChange,
  type Candidate,
  createRepair,
  createRetime,
  createSearch,
  type Effort,
  findSlackInSteps,
  type Proposal,
  type Steps,
  verifyRun,
} from '../../solver/index.ts';
import { carryNotes } from '../runs/index.ts';
import { seekTakeBacks, type TakenBack } from './take-back.ts';
import { unitsOf } from './units.ts';

/** What {@link createMend} is asked. */
export interface MendOptions {
  /** The file before the change, which the run completes. */
  readonly before: LevelFile;
  /** The file after the change. */
  readonly after: LevelFile;
  /** The terms under which the run completes the one, and has to complete the other. */
  readonly terms: Terms;
  /** The name of the run. */
  readonly run: string;
  /** The name of a run that a search finds; no other run of the file may have it. */
  readonly newRun: string;
  /** Seed of the searches, a whole number; 0 by default. */
  readonly seed?: number;
}

/** A change with which a run completes the level again. A replay of its file from the start has confirmed it. */
export interface Mended {
  /** What is done: the change is taken back in part, holds are shifted, something else is changed, or there is another run. */
  readonly how:
    | { readonly kind: 'back'; readonly taken: TakenBack }
    | { readonly kind: 'retime' | 'change' | 'run'; readonly proposal: Proposal };
  /** The file as it would be written. */
  readonly file: LevelFile;
  /** The name of the run that completes it. */
  readonly run: string;
  readonly time: number;
  readonly minerals: number;
  /** How far each press and release alone may slip at least, ticks; null for a run without holds. */
  readonly slack: number | null;
}

/** A search for small changes that mend a level which a change has broken. It has what it has found so far. */
export interface Mend {
  /** Parts of the change to take back, then other holds, other changes, and another run. */
  readonly found: readonly Mended[];
  readonly effort: Effort;
  /** True when nothing more is tried. */
  readonly finished: boolean;
  /** @param ticks how many more ticks to simulate; it may overshoot by a few runs */
  advance(ticks: number): void;
}

/** Ticks for the holds, for other changes, and for another run. */
const EFFORT = { retime: 2_000_000, repair: 4_000_000, search: 1_000_000 } as const;

/** Ticks between two breaks. */
const SLICE = 2000;

/** The largest slip that is tried, ticks. */
const SLACK = 30;

/**
 * Creates a search for the smallest changes that mend a level which a change has broken: the least that must be taken back of that
 * change, the fewest presses and releases to shift, another change, and another run.
 * @param options the files before and after the change, and the run
 * @returns a search at its start
 */
export function createMend({ before, after, terms, run, newRun, seed = 0 }: MendOptions): Mend {
  const { rules } = terms;
  let found: Mended[] = [];
  let effort: Effort = { runs: 0, ticks: 0 };
  const spend = (runs: number, ticks: number) => {
    effort = { runs: effort.runs + runs, ticks: effort.ticks + ticks };
  };
  /** Plays a run of a file from the start. */
  const play = (file: LevelFile, name: string): Candidate | null => {
    const level = resolveLevel(file, rules);
    const own = level.runs.find((one) => one.name === name);
    const candidate = own === undefined ? null : verifyRun(compile(level, terms), own.holds);
    spend(1, candidate?.tick ?? 600);
    return candidate === null || candidate.time === 0 ? null : candidate;
  };
  /** Judges a file as it would be written, and measures what its run forgives. */
  function* judged(how: Mended['how'], file: LevelFile, name: string): Steps<Mended | null> {
    const candidate = play(file, name);
    if (candidate === null) return null;
    const level = resolveLevel(file, rules);
    const holds = joinHolds(level.runs.find((one) => one.name === name)?.holds ?? []);
    const steps = findSlackInSteps(compile(level, terms), holds, { minerals: 'any' }, SLACK);
    for (;;) {
      const step = steps.next();
      spend(1, candidate.tick);
      if (step.done === true) {
        const least = Math.min(...step.value.map(({ earlier, later }) => Math.min(earlier, later)));
        const slack = step.value.length === 0 ? null : least;
        return { how, file, run: name, time: candidate.time, minerals: candidate.minerals.length, slack };
      }
      yield null;
    }
  }
  const level = resolveLevel(after, rules);
  const own = level.runs.findIndex(({ name }) => name === run);
  const nameOf = ({ origin }: Proposal): string => (origin.from === 'search' ? newRun : level.runs[origin.index].name);
  const proposed = (kind: 'retime' | 'change' | 'run', proposal: Proposal): Steps<Mended | null> =>
    judged({ kind, proposal }, repairedFile(after, proposal, newRun), nameOf(proposal));

  function* back(): Steps<void> {
    const parts: TakenBack[] = [];
    const completes = (file: LevelFile) => play(file, run) !== null;
    for (const _ of seekTakeBacks(after, unitsOf(before, after, rules), completes, (taken) => void parts.push(taken))) yield null;
    for (const taken of parts) {
      const one = yield* judged({ kind: 'back', taken }, taken.file, run);
      if (one !== null) found = [...found, one];
    }
  }
  function* retime(): Steps<void> {
    const [scene, former] = [compile(level, terms), play(before, run)];
    const minerals = former?.minerals.filter((index) => index < level.minerals.length) ?? [];
    const { holds } = level.runs[own];
    const work = createRetime(scene, holds, { minerals, formerEnd: former?.tick, prefers: 'fewest' });
    let spent = work.effort;
    while (!work.finished && work.effort.ticks < EFFORT.retime) {
      work.advance(SLICE);
      spend(work.effort.runs - spent.runs, work.effort.ticks - spent.ticks);
      spent = work.effort;
      yield null;
    }
    if (work.best === null) return;
    const { run: candidate, holds: shifted, total } = work.best;
    const proposal: Proposal = {
      change: null,
      size: 0,
      run: { ...candidate, holds: shifted },
      origin: { from: 'adjusted', index: own, ticks: total },
    };
    const one = yield* proposed('retime', proposal);
    if (one !== null) found = [...found, one];
  }
  function* repair(): Steps<void> {
    const work = createRepair(level, terms, { seed });
    const others = found;
    let shown: readonly Proposal[] = [];
    let spent = work.effort;
    const isChange = ({ change }: Proposal) => change !== null;
    while (!work.finished && work.effort.ticks < EFFORT.repair) {
      work.advance(SLICE);
      spend(work.effort.runs - spent.runs, work.effort.ticks - spent.ticks);
      spent = work.effort;
      yield null;
      const now = work.proposals.filter(isChange);
      if (now.length === shown.length && now.every((proposal, i) => proposal === shown[i])) continue;
      shown = now;
      const mended: Mended[] = [];
      for (const proposal of now) {
        const one = yield* proposed('change', proposal);
        if (one !== null) mended.push(one);
      }
      found = [...others, ...mended];
    }
  }
  function* search(): Steps<void> {
    const work = createSearch(compile(level, terms), { seed });
    let spent: Effort = { ...work.effort };
    while (work.solutions.length === 0 && !work.exhausted && work.effort.ticks < EFFORT.search) {
      work.advance(SLICE);
      spend(work.effort.runs - spent.runs, work.effort.ticks - spent.ticks);
      spent = { ...work.effort };
      yield null;
    }
    const candidate = work.solutions.find(({ time }) => time > 0);
    if (candidate === undefined) return;
    const one = yield* proposed('run', { change: null, size: 0, run: candidate, origin: { from: 'search' } });
    if (one !== null) found = [...found, one];
  }
  function* work(): Steps<void> {
    yield* back();
    if (own >= 0 && level.runs[own].holds.length > 0) yield* retime();
    yield* repair();
    yield* search();
  }
  const steps = work();
  let asked = 0;
  let finished = false;
  return {
    get found() {
      return found;
    },
    get effort() {
      return effort;
    },
    get finished() {
      return finished;
    },
    advance(ticks) {
      asked += ticks;
      while (!finished && effort.ticks < asked) finished = steps.next().done === true;
    },
  };
}

/**
 * Makes the content of a level file after a proposal. Nothing else changes: keys of its own (`x-`) and what is left out stay so.
 * @param file the content of the level's file
 * @param proposal a proposal for the level of this file
 * @param runName the name of a run that a search found; no other run of the file may have it
 * @returns the changed copy: a run with other holds stands in its place and
 * keeps its notes, a run that a search found comes after the others
 */
export function repairedFile(file: LevelFile, { change, run, origin }: Proposal, runName: string): LevelFile {
  const changed = change === null ? file : applyChange(file, change);
  if (origin.from === 'own') return changed;
  const holds = run.holds.map(([press, release]): [number, number] => [press, release]);
  const runs = changed.runs ?? [];
  if (origin.from === 'search') return { ...changed, runs: [...runs, { name: runName, holds }] };
  const put = (other: (typeof runs)[number]) => {
    if (other.notes === undefined) return { ...other, holds };
    return { ...other, holds, notes: carryNotes(other.notes, joinHolds(other.holds), holds) };
  };
  return { ...changed, runs: runs.map((other, i) => (i === origin.index ? put(other) : other)) };
}

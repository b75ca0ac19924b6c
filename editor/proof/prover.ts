import {
  type AccuracyName,
  compile,
  createSimulation,
  DEFAULT_MAX_TIME,
  type Ending,
  joinHolds,
  playScript,
  type Run,
  type Scene,
  simulate,
  TICK,
  TICK_RATE,
} from '../../engine/index.ts';
import { type Hold, type Level, type LevelFile, OBJECT_LISTS, type Problem, resolveLevel } from '../../schema/index.ts';
import { firstDifference, March, type Marched, MarchRoom, type Way } from './march.ts';
import { type Margins, marginsOf } from './margins.ts';
import type { RunEnd } from './outcome.ts';
import { problemsOf } from './problems.ts';

/** What is asked of a level while it is edited. */
export interface Question {
  readonly file: LevelFile;
  /** Name of the run that is shown; the first one when there is none of that name or it is null. */
  readonly run: string | null;
  readonly accuracy: AccuracyName;
}

/** The run that is shown, simulated. */
export interface ShownRun extends RunEnd {
  /** null where the level has no run: she drifts */
  readonly name: string | null;
  /** as they act: sorted and joined */
  readonly holds: readonly Hold[];
  readonly way: Way;
  /** those collected, each once, with the tick */
  readonly minerals: Marched['minerals'];
  /** The tick from which on this was simulated anew. */
  readonly resumedFrom: number;
}

/** Everything the editor shows about a level that is not in its file. Arrays in `run.way` are good until the next answer. */
export interface LiveProof {
  readonly file: LevelFile;
  readonly level: Level;
  /** Of the same objects as `level`; its runs may be older ones. */
  readonly scene: Scene;
  readonly accuracy: AccuracyName;
  readonly run: ShownRun;
  /** As `gq check` has it. */
  readonly verdict: 'completable' | 'broken' | 'unproven';
  /** Name of a run that completes the level: the shown one if it does, else the first; null where none does. */
  readonly provenBy: string | null;
  /** What this answer cost, ms of wall time. */
  readonly ms: number;
  /** What is wrong and what looks wrong; `line` and `column` are null. Made when asked for: it simulates all runs in full. */
  readonly problems: readonly Problem[];
  /** The shown run with its events, exact times and hash. Made when asked for. */
  readonly full: Run;
  /** Clearance and speed along the shown run. Made when asked for. */
  readonly margins: Margins;
}

export interface Prover {
  /** The same question gives the same object. */
  prove(question: Question): LiveProof;
}

const MAX_TICKS = Math.round(DEFAULT_MAX_TIME * TICK_RATE);

const toEnd = (ending: Ending | null): RunEnd =>
  ending ?? { outcome: 'timeout', with: null, time: MAX_TICKS * TICK, tick: MAX_TICKS };

/** Whether two files have the same objects, so that they play alike. What they share is compared at once. */
function playsAlike(a: LevelFile, b: LevelFile): boolean {
  if (a.range !== b.range || a.recoil !== b.recoil || a.astronaut !== b.astronaut || a.blackHole !== b.blackHole) return false;
  return OBJECT_LISTS.every((list) => a[list] === b[list]);
}

/** What is known of one scene: runs by their holds. */
class SceneRecord {
  readonly scene: Scene;
  readonly march: March;
  private readonly ends = new Map<string, RunEnd>();
  private readonly fulls = new Map<string, Run>();

  constructor(
    readonly file: LevelFile,
    level: Level,
    readonly accuracy: AccuracyName,
    room: MarchRoom,
  ) {
    this.scene = compile(level, accuracy);
    this.march = new March(this.scene, MAX_TICKS, room);
  }

  /** How a script ends; nothing else is recorded. @param holds sorted and disjoint */
  end(holds: readonly Hold[]): RunEnd {
    const key = holds.join();
    const known = this.ends.get(key);
    if (known !== undefined) return known;
    const simulation = createSimulation(this.scene);
    playScript(simulation, holds, MAX_TICKS);
    const end = toEnd(simulation.ending);
    this.ends.set(key, end);
    return end;
  }

  full(holds: readonly Hold[]): Run {
    const key = holds.join();
    const run = this.fulls.get(key) ?? simulate(this.scene, holds);
    // dragging a hold asks for a new one each time
    if (this.fulls.size > 64) this.fulls.clear();
    this.fulls.set(key, run);
    return run;
  }
}

/** Of several minerals touched in one frame `arcade` takes only one away, but counts them all: only the full record knows them. */
function takenInFrames(run: Run): Marched['minerals'] {
  const first = new Map<number, number>();
  for (const { index, time } of run.minerals) if (!first.has(index)) first.set(index, Math.round(time * TICK_RATE));
  return [...first].map(([index, tick]) => ({ index, tick }));
}

/** Which run proves the level, or null. The one that did last time is asked first. */
function findProof(record: SceneRecord, level: Level, shown: ShownRun, last: string | null): string | null {
  if (shown.name !== null && shown.outcome === 'completed') return shown.name;
  const others = level.runs.filter(({ name }) => name !== shown.name);
  const completes = (run: { readonly holds: readonly Hold[] }) => record.end(joinHolds(run.holds)).outcome === 'completed';
  const again = others.find(({ name }) => name === last);
  if (again !== undefined && others[0] === again && completes(again)) return again.name;
  return others.find(completes)?.name ?? null;
}

/**
 * Answers what the editor shows, again and again while a level changes. While only runs change the scene is kept, and while only the end of the shown run
 * changes its beginning is.
 * @param now a clock in ms, to tell what an answer cost
 */
export function createProver(now: () => number = () => performance.now()): Prover {
  const room = new MarchRoom();
  let record: SceneRecord | null = null;
  let answer: LiveProof | null = null;

  const recordOf = (file: LevelFile, level: Level, accuracy: AccuracyName): SceneRecord => {
    if (record === null || record.accuracy !== accuracy || !playsAlike(record.file, file)) {
      record = new SceneRecord(file, level, accuracy, room);
    }
    return record;
  };

  const showRun = (known: SceneRecord, level: Level, wanted: string | null): ShownRun => {
    const run = level.runs.find(({ name }) => name === wanted) ?? level.runs[0];
    const joined = joinHolds(run?.holds ?? []);
    // the same list as before, so that who shows it sees that it is
    const before = answer?.run.holds ?? joined;
    const holds = firstDifference(before, joined) === Number.POSITIVE_INFINITY ? before : joined;
    const { way, ending, minerals, resumedFrom } = known.march.run(holds);
    const taken = known.accuracy === 'arcade' && minerals.length > 0 ? takenInFrames(known.full(holds)) : minerals;
    return { name: run?.name ?? null, holds, way, minerals: taken, resumedFrom, ...toEnd(ending) };
  };

  return {
    prove({ file, run: wanted, accuracy }) {
      if (answer !== null && answer.file === file && answer.accuracy === accuracy) {
        const asked = file.runs?.some(({ name }) => name === wanted) ? wanted : (file.runs?.[0]?.name ?? null);
        if (answer.run.name === asked) return answer;
      }
      const start = now();
      const level = resolveLevel(file);
      const known = recordOf(file, level, accuracy);
      const run = showRun(known, level, wanted);
      const provenBy = findProof(known, level, run, answer?.provenBy ?? null);
      const verdict = provenBy !== null ? 'completable' : level.runs.length === 0 ? 'unproven' : 'broken';
      let problems: readonly Problem[] | null = null;
      let margins: Margins | null = null;
      answer = {
        file,
        level,
        scene: known.scene,
        accuracy,
        run,
        verdict,
        provenBy,
        ms: now() - start,
        get problems() {
          problems ??= problemsOf(level, accuracy, (holds) => known.full(joinHolds(holds)));
          return problems;
        },
        get full() {
          return known.full(run.holds);
        },
        get margins() {
          margins ??= marginsOf(known.scene, run.way);
          return margins;
        },
      };
      return answer;
    },
  };
}

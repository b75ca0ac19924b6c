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
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import { type Hold, type Level, type LevelFile, OBJECT_LISTS, type Problem, resolveLevel } from '../../schema/index.ts';
import { firstDifference, March, type Marched, MarchRoom, type Way } from './march.ts';
import { type Margins, marginsOf } from './margins.ts';
import { outcomeInWords, type RunEnd } from './outcome.ts';
import { bareOf, type Limit, limitInWords, MOST_WORK } from './patience.ts';
import { limitProblem, problemsOf } from './problems.ts';

/** What is asked of a level while it is edited. */
export interface Question {
  readonly file: LevelFile;
  /** Name of the run that is shown; the first one when there is none of that name or it is null. */
  readonly run: string | null;
  readonly accuracy: AccuracyName;
  /** How long the answer may take, ms, about: what takes longer is left out and said. No limit when left out; 0: nothing is played. */
  readonly patience?: number;
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
  /** What was left out; null: nothing, all here is as `gq check` has it. Otherwise the verdict is what is known without. */
  readonly limit: Limit | null;
  /** Name of a run that completes the level: the shown one if it does, else the first; null where none does. */
  readonly provenBy: string | null;
  /** What this answer cost, ms of wall time. */
  readonly ms: number;
  /** What is wrong and what looks wrong; `line` and `column` are null. Made when asked for: it simulates all runs in full. */
  readonly problems: readonly Problem[];
  /** The shown run with its events, exact times and hash. Made when asked for; null where it was not played to its end. */
  readonly full: Run | null;
  /** Clearance and speed along the shown run. Made when asked for. */
  readonly margins: Margins;
}

/** Whether the shown run was played to its end. */
export const isWhole = ({ limit }: Pick<LiveProof, 'limit'>): boolean => limit === null || limit === 'others';

/** How the shown run ends, for a person, or why that is not known. */
export const endInWords = ({ limit, run, level }: Pick<LiveProof, 'limit' | 'run' | 'level'>): string =>
  limit === null || limit === 'others' ? outcomeInWords(run, level.range) : limitInWords(limit);

export interface Prover {
  /** The same question gives the same object. */
  prove(question: Question): LiveProof;
}

/** Ticks between two looks at the clock. */
const STRIDE = 60;

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
  /** What is played for one answer. */
  readonly budget: WorkBudget;
  private readonly ends = new Map<string, RunEnd>();
  private readonly fulls = new Map<string, Run>();

  constructor(
    readonly file: LevelFile,
    level: Level,
    readonly accuracy: AccuracyName,
    room: MarchRoom,
    /** pieces of motion for one answer */
    readonly work: number,
  ) {
    this.scene = compile(level, accuracy);
    this.budget = new WorkBudget(work, Number.POSITIVE_INFINITY);
    this.march = new March(this.scene, MAX_TICKS, room, this.budget);
  }

  /** How a script ends; nothing else is recorded. @param holds sorted and disjoint @returns null: it was given up */
  end(holds: readonly Hold[], isLate: () => boolean): RunEnd | null {
    const key = holds.join();
    const known = this.ends.get(key);
    if (known !== undefined) return known;
    try {
      const simulation = createSimulation(this.scene, this.budget);
      while (simulation.ending === null && simulation.tick < MAX_TICKS) {
        if (isLate()) return null;
        playScript(simulation, holds, Math.min(MAX_TICKS, simulation.tick + STRIDE));
      }
      const end = toEnd(simulation.ending);
      this.ends.set(key, end);
      return end;
    } catch (error) {
      if (error instanceof WorkLimitReached) return null;
      throw error;
    }
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

/** Which run proves the level, or null; and whether some were given up. The one that did last time is asked first. */
function findProof(
  record: SceneRecord,
  level: Level,
  shown: ShownRun,
  last: string | null,
  isLate: () => boolean,
): { readonly name: string | null; readonly isWhole: boolean } {
  if (shown.name !== null && shown.outcome === 'completed') return { name: shown.name, isWhole: true };
  const others = level.runs.filter(({ name }) => name !== shown.name);
  let isWhole = true;
  const completes = (run: { readonly holds: readonly Hold[] }): boolean => {
    const end = isWhole ? record.end(joinHolds(run.holds), isLate) : null;
    isWhole &&= end !== null;
    return end?.outcome === 'completed';
  };
  const again = others.find(({ name }) => name === last);
  if (again !== undefined && others[0] === again && completes(again)) return { name: again.name, isWhole: true };
  const found = others.find(completes)?.name ?? null;
  return { name: found, isWhole: found !== null || isWhole };
}

/**
 * Answers what the editor shows, again and again while a level changes. While only runs change the scene is kept, and while only the end of the shown run
 * changes its beginning is.
 * @param now a clock in ms, to tell what an answer cost
 * @param most pieces of motion that are played for one answer to who is not infinitely patient
 */
export function createProver(now: () => number = () => performance.now(), most = MOST_WORK): Prover {
  const room = new MarchRoom();
  let record: SceneRecord | null = null;
  let answer: (LiveProof & { readonly patience: number }) | null = null;

  /** What is shown of a level that is not played: she stands at the start. */
  let still: SceneRecord | null = null;
  /** null: the level takes too much work to be begun */
  const recordOf = (file: LevelFile, level: Level, accuracy: AccuracyName, work: number): SceneRecord | null => {
    if (record !== null && record.accuracy === accuracy && record.work >= work && playsAlike(record.file, file)) {
      record.budget.looks = 0;
      return record;
    }
    still = null;
    record = null;
    try {
      record = new SceneRecord(file, level, accuracy, room, work);
    } catch (error) {
      if (!(error instanceof WorkLimitReached)) throw error;
    }
    return record;
  };
  const stillOf = (file: LevelFile, level: Level, accuracy: AccuracyName): SceneRecord => {
    if (still === null || still.accuracy !== accuracy || !playsAlike(still.file, file)) {
      // they share the arrays of their ways
      record = null;
      still = new SceneRecord(file, bareOf(level), accuracy, room, Number.POSITIVE_INFINITY);
    }
    return still;
  };

  const showRun = (
    known: SceneRecord,
    level: Level,
    wanted: string | null,
    isLate: () => boolean,
  ): ShownRun & { isCut: boolean } => {
    const run = level.runs.find(({ name }) => name === wanted) ?? level.runs[0];
    const joined = joinHolds(run?.holds ?? []);
    // the same list as before, so that who shows it sees that it is
    const before = answer?.run.holds ?? joined;
    const holds = firstDifference(before, joined) === Number.POSITIVE_INFINITY ? before : joined;
    const { way, ending, minerals, resumedFrom, isCut } = known.march.run(holds, isLate);
    const inFrames = known.accuracy === 'arcade' && minerals.length > 0 && !isCut;
    const taken = inFrames ? takenInFrames(known.full(holds)) : minerals;
    const tick = Math.max(0, way.count - 1);
    const end: RunEnd = isCut ? { outcome: 'timeout', with: null, time: tick * TICK, tick } : toEnd(ending);
    return { name: run?.name ?? null, holds, way, minerals: taken, resumedFrom, isCut, ...end };
  };

  return {
    prove({ file, run: wanted, accuracy, patience = Number.POSITIVE_INFINITY }) {
      const isSame = answer !== null && answer.file === file && answer.accuracy === accuracy;
      if (answer !== null && isSame && (answer.limit === null || answer.patience >= patience)) {
        const asked = file.runs?.some(({ name }) => name === wanted) ? wanted : (file.runs?.[0]?.name ?? null);
        if (answer.run.name === asked) return answer;
      }
      const start = now();
      const level = resolveLevel(file);
      const isPatient = patience === Number.POSITIVE_INFINITY;
      const begun = patience === 0 ? null : recordOf(file, level, accuracy, isPatient ? patience : most);
      const nothing: Limit | null = begun !== null ? null : patience === 0 ? 'unchecked' : 'everything';
      const isLate = nothing !== null ? () => true : isPatient ? () => false : () => now() - start > patience;
      const known = begun ?? stillOf(file, level, accuracy);
      const { isCut, ...run } = showRun(known, level, wanted, isLate);
      const { name: provenBy, isWhole: areAllKnown } = isCut
        ? { name: null, isWhole: level.runs.length === 0 }
        : findProof(known, level, run, answer?.provenBy ?? null, isLate);
      const limit: Limit | null = nothing ?? (isCut ? 'run' : areAllKnown ? null : 'others');
      const verdict = provenBy !== null ? 'completable' : level.runs.length === 0 || limit !== null ? 'unproven' : 'broken';
      let problems: readonly Problem[] | null = null;
      let margins: Margins | null = null;
      answer = {
        file,
        level,
        scene: known.scene,
        accuracy,
        run,
        verdict,
        limit,
        patience,
        provenBy,
        ms: now() - start,
        get problems() {
          // a worker finds those of levels that take long
          problems ??=
            limit === null ? problemsOf(level, accuracy, (holds) => known.full(joinHolds(holds))) : [limitProblem(limit)];
          return problems;
        },
        get full() {
          return isCut ? null : known.full(run.holds);
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

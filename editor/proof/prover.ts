import { examineRuns, type RunFindings, verdictOf } from '../../check/index.ts';
import type { RunEnd } from '../../check/words/index.ts';
import { type AccuracyName, joinHolds, type Run, TICK, TICK_RATE, WorkBudget, WorkLimitReached } from '../../engine/index.ts';
import { type Level, type LevelFile, type Problem, resolveLevel } from '../../schema/index.ts';
import type { LiveProof, Question, ShownRun } from './answer.ts';
import { asGqCheck } from './as-gq-check.ts';
import { findProvingRun } from './find-proving-run.ts';
import { firstDifference, type Marched, MarchRoom } from './march.ts';
import { type Margins, marginsOf } from './margins.ts';
import { bareOf, type Limit, MOST_WORK } from './patience.ts';
import { playsAlike, SceneRecord, toEnd } from './scene-record.ts';
import { toldProblems } from './told.ts';

export interface Prover {
  /** The same question gives the same object. */
  prove(question: Question): LiveProof;
}

const NOTHING_PROVED = { impossible: null, minerals: [] };

/** What the runs of a level show: each is simulated in full, once. */
function findingsIn(known: SceneRecord, level: Level): RunFindings {
  const runs = level.runs.map(({ holds }) => known.full(joinHolds(holds)));
  return examineRuns(level, runs, asGqCheck(known.accuracy, new WorkBudget()));
}

/** Of several minerals touched in one frame `arcade` takes only one away, but counts them all: only the full record knows them. */
function takenInFrames(run: Run): Marched['minerals'] {
  const first = new Map<number, number>();
  for (const { index, time } of run.minerals) if (!first.has(index)) first.set(index, Math.round(time * TICK_RATE));
  return [...first].map(([index, tick]) => ({ index, tick }));
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
        : findProvingRun(known, level, run, answer?.provenBy ?? null, isLate);
      const limit: Limit | null = nothing ?? (isCut ? 'run' : areAllKnown ? null : 'others');
      const verdict = verdictOf({
        isCompleted: provenBy !== null,
        isImpossible: false,
        runs: level.runs.length,
        areAllPlayed: limit === null,
      });
      let findings: RunFindings | null = null;
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
        get findings() {
          // a worker finds those of levels that take long
          if (limit === null) findings ??= findingsIn(known, level);
          return findings;
        },
        get problems() {
          problems ??= toldProblems(this, null, NOTHING_PROVED);
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

import { examineRuns, playRuns, type RunFindings, unproved, verdictOfFindings } from '../../../check/index.ts';
import { joinHolds, WorkBudget } from '../../../engine/index.ts';
import { type Level, type Problem, resolveLevel } from '../../../schema/index.ts';
import type { LiveProof, Question } from './answer.ts';
import { findProvingRun } from './find-proving-run.ts';
import { type Margins, marginsOf } from './margins.ts';
import { type Limit, MOST_WORK } from './patience.ts';
import { createSceneKeeper } from './scene-keeper.ts';
import type { SceneRecord } from './scene-record.ts';
import { showRun } from './show-run.ts';
import { toldProblems } from './told.ts';

export interface Prover {
  /** Equal questions give the same object. */
  prove(question: Question): LiveProof;
}

const NOTHING_PROVED = { impossible: null, minerals: [] };

/** The findings of a level's runs, as a check has them; each is simulated completely, once, unless that exceeds the work limit. */
function findingsIn(known: SceneRecord, level: Level): RunFindings {
  const { scene, terms } = known;
  const counted = level.runs.map(({ holds }) => known.full(joinHolds(holds)));
  const budget = new WorkBudget(terms.maxWork);
  budget.looks = counted.reduce((sum, { looks }) => sum + looks, 0);
  if (!budget.isUsedUp)
    return examineRuns(
      level,
      counted.map(({ run }) => run),
      { scene, budget },
    );
  const limited = new WorkBudget(terms.maxWork);
  return examineRuns(level, playRuns(scene, limited, level.runs), { scene, budget: limited });
}

/**
 * Computes what the editor shows, again and again while a level changes. If only runs change, the scene is kept; if only the
 * end of the shown run changes, its beginning is kept.
 * @param now a clock in ms, for the cost of an answer
 * @param most pieces of motion that are simulated per answer if the patience is limited
 */
export function createProver(now: () => number = () => performance.now(), most = MOST_WORK): Prover {
  const scenes = createSceneKeeper();
  let answer: (LiveProof & { readonly patience: number }) | null = null;
  return {
    prove({ file, run: wanted, terms, patience = Number.POSITIVE_INFINITY }) {
      const isSame = answer !== null && answer.file === file && answer.terms === terms;
      if (answer !== null && isSame && (answer.limit === null || answer.patience >= patience)) {
        const asked = file.runs?.some(({ name }) => name === wanted) ? wanted : (file.runs?.[0]?.name ?? null);
        if (answer.run.name === asked) return answer;
      }
      const start = now();
      // the same object for another run or more patience, so that subscribers see no change of the level
      const level = answer?.file === file && answer.terms.rules === terms.rules ? answer.level : resolveLevel(file, terms.rules);
      const isPatient = patience === Number.POSITIVE_INFINITY;
      const begun =
        patience === 0 ? null : scenes.played(file, level, terms, isPatient ? terms.maxWork : Math.min(most, terms.maxWork));
      const nothing: Limit | null = begun !== null ? null : patience === 0 ? 'unchecked' : 'everything';
      const isLate = nothing !== null ? () => true : isPatient ? () => false : () => now() - start > patience;
      const known = begun ?? scenes.still(file, level, terms);
      const { isCut, looks, ...run } = showRun(known, level, wanted, answer?.run.holds ?? null, isLate);
      const shown = { ...run, looks, isCut };
      const { name: provenBy, ends } = findProvingRun(known, level, shown, isLate);
      const limit: Limit | null = nothing ?? (isCut ? 'run' : ends.some(({ isStopped }) => isStopped) ? 'others' : null);
      const verdict = verdictOfFindings({ ...unproved, ends });
      let findings: RunFindings | null = null;
      let problems: readonly Problem[] | null = null;
      let margins: Margins | null = null;
      answer = {
        file,
        level,
        scene: known.scene,
        terms,
        run,
        verdict,
        limit,
        patience,
        provenBy,
        ms: now() - start,
        get findings() {
          // a worker computes the findings of levels that take long
          if (limit === null) findings ??= findingsIn(known, level);
          return findings;
        },
        get problems() {
          problems ??= toldProblems(this, null, NOTHING_PROVED);
          return problems;
        },
        get full() {
          return isCut ? null : known.full(run.holds).run;
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

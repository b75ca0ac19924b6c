import { examineRuns, playRuns, type RunFindings, unproved, verdictOfFindings } from '../../../check/index.ts';
import { firstDifference } from '../../../check/runs/index.ts';
import type { RunEnd } from '../../../check/words/index.ts';
import { joinHolds, type Run, TICK, TICK_RATE, WorkBudget } from '../../../engine/index.ts';
import { type Hold, type Level, type Problem, resolveLevel } from '../../../schema/index.ts';
import { type Limit, type LiveProof, MOST_WORK, type Question, type ShownRun } from './answer.ts';
import { knownProblems } from './known-problems.ts';
import { type Margins, marginsOf } from './margins.ts';
import type { RecordedRun } from './recorder.ts';
import { createSceneKeeper, type SceneRecord, toEnd } from './scene-record.ts';

interface Prover {
  /** Equal questions give the same object. */
  prove(question: Question): LiveProof;
}

const NOTHING_PROVED = { impossible: null, minerals: [] };

/** The findings of a level's runs, as a check has them; each is simulated completely, once, unless that exceeds the work limit. */
function findingsIn(known: SceneRecord, level: Level): RunFindings {
  const { scene, terms } = known;
  const counted = level.runs.map(({ holds }) => known.full(joinHolds(holds)));
  const sum = (looks: (run: (typeof counted)[number], index: number) => number): number =>
    counted.reduce((all, run, index) => all + looks(run, index), 0);
  const budget = new WorkBudget(terms.maxWork);
  budget.looks = sum(({ looks }) => looks);
  const runs = counted.map(({ run }) => run);
  const found = budget.isUsedUp ? null : examineRuns(level, runs, { scene, budget });
  // what runs come near to costs work, too, and a check, which records only the first one, plays the others again for it
  budget.looks = sum(({ looks, all }, index) => all.looks + (index === 0 ? 0 : looks));
  if (found !== null && !budget.isUsedUp) return found;
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
      const { isCut, ...run } = showRun(known, level, wanted, answer?.run.holds ?? null, isLate);
      const shown = { ...run, isCut };
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
          problems ??= knownProblems(this, null, NOTHING_PROVED);
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

/** What the runs of a level show. */
interface Proving {
  /** A run that completes the level; null if none is known. */
  readonly name: string | null;
  /** How runs end, as far as the verdict needs it; those that were not simulated to their end are stopped. */
  readonly ends: RunFindings['ends'];
}

/** How a run ends. @param end null: it was stopped */
const endAs = ({ name }: Level['runs'][number], end: RunEnd | null): RunFindings['ends'][number] => ({
  ...(end ?? { outcome: 'timeout', with: null, time: 0, tick: 0 }),
  name,
  isStopped: end === null,
});

/**
 * Finds a run that completes the level: the shown one if possible, else the first. As in a check, the runs share the work that the
 * level may cost, in their order: a run counts if it and those before it do not exceed that.
 * @param shown the shown run, and whether it was stopped: then nothing more is simulated
 */
function findProvingRun(
  record: SceneRecord,
  { runs }: Level,
  shown: ShownRun & { readonly isCut: boolean },
  isLate: () => boolean,
): Proving {
  const { maxWork } = record.terms;
  const { most } = new WorkBudget(maxWork);
  /** How run `i` ends; null: it was not simulated to its end. */
  const endOf = (i: number) =>
    shown.isCut ? null : runs[i].name === shown.name ? shown : record.end(joinHolds(runs[i].holds), isLate);
  /** What a check counts for run `k`, of which it records only the first. */
  const looksOf = (k: number): number =>
    endOf(k) === null ? Number.POSITIVE_INFINITY : record.full(joinHolds(runs[k].holds), k === 0).looks;
  /** Whether the runs up to the `i`-th cost no more than allowed. So few that the page simulates them cannot. */
  const isPaidFor = (i: number): boolean => {
    let looks = 0;
    if (maxWork < MOST_WORK * (i + 1)) for (let k = 0; k <= i; k++) looks += looksOf(k);
    return looks <= most;
  };
  const own = runs.findIndex(({ name }) => name === shown.name);
  if (own >= 0 && endOf(own)?.outcome === 'completed' && isPaidFor(own))
    return { name: runs[own].name, ends: [endAs(runs[own], shown)] };
  const ends: RunFindings['ends'][number][] = [];
  for (const [i, run] of runs.entries()) {
    const end = isPaidFor(i) ? endOf(i) : null;
    ends.push(endAs(run, end));
    if (end === null) break;
    if (end.outcome === 'completed') return { name: run.name, ends };
  }
  return { name: null, ends };
}

/**
 * If several minerals are touched in one frame, `arcade` removes only one but counts them all; only the full record knows them.
 */
function takenInFrames(run: Run): RecordedRun['minerals'] {
  const first = new Map<number, number>();
  for (const { index, time } of run.minerals) if (!first.has(index)) first.set(index, Math.round(time * TICK_RATE));
  return [...first].map(([index, tick]) => ({ index, tick }));
}

/**
 * Simulates the shown run tick by tick.
 * @param wanted its name; the first run if there is none of that name
 * @param shown holds of the previously shown run; null: none
 * @param isLate called before each tick: whether to stop
 */
function showRun(
  known: SceneRecord,
  level: Level,
  wanted: string | null,
  shown: readonly Hold[] | null,
  isLate: () => boolean,
): ShownRun & { readonly isCut: boolean } {
  const run = level.runs.find(({ name }) => name === wanted) ?? level.runs[0];
  const joined = joinHolds(run?.holds ?? []);
  // the same list as before if it is equal, so that subscribers see no change
  const before = shown ?? joined;
  const holds = firstDifference(before, joined) === Number.POSITIVE_INFINITY ? before : joined;
  const { way, ending, minerals, resumedFrom, isCut } = known.recorder.run(holds, isLate);
  const inFrames = known.scene.accuracy.integrator === 'arcade' && minerals.length > 0 && !isCut;
  const taken = inFrames ? takenInFrames(known.full(holds).run) : minerals;
  const tick = Math.max(0, way.count - 1);
  const end: RunEnd = isCut ? { outcome: 'timeout', with: null, time: tick * TICK, tick } : toEnd(ending, known.maxTicks);
  return { name: run?.name ?? null, holds, way, minerals: taken, resumedFrom, isCut, ...end };
}

import { compile, type Run, type Scene, simulate, type Terms, WorkBudget } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import type { Proof } from '../solver/index.ts';
import { type LevelVerdict, type RunFindings, scriptEnds, verdictOfFindings } from './findings.ts';
import { proofBudget, proveGoalImpossible } from './proofs.ts';

/** What is true of a level under some terms by its own runs and by proof, without a search and without its problems. */
export interface Brief {
  readonly scene: Scene;
  /** The runs, in the order of the level's list; only the first has a recording. */
  readonly runs: readonly Run[];
  /** How the runs end, in the order of the level's list. */
  readonly ends: RunFindings['ends'];
  /** A proof that nobody can complete the level; null when a run completes it, or none was found. */
  readonly impossible: Proof | null;
  readonly verdict: LevelVerdict;
  /** The index of the first run that completes the level, else 0; null when the level has no runs. */
  readonly shown: number | null;
  /** That run; null when the level has none, or it took too much work. What is read of it spends the budget. */
  readonly run: Run | null;
  /** What is left of the work that the runs may cost. */
  readonly budget: WorkBudget;
  /** What is left of the work that proofs may cost. */
  readonly proofs: WorkBudget;
}

/**
 * Judges a level as `gq check` does when it neither searches nor measures. Yields between its parts, each of which is one
 * simulation or the search for a proof.
 * @param level the level
 * @param terms under which it is judged
 */
export function* briefInSteps(level: Level, terms: Terms): Generator<null, Brief, void> {
  const scene = compile(level, terms);
  // each part of a check has a budget of its own, so that none uses up another's
  const budget = new WorkBudget(terms.maxWork);
  const proofs = proofBudget(scene);
  const runs: Run[] = [];
  for (const { holds } of level.runs) {
    if (runs.length > 0) yield null;
    runs.push(simulate(scene, holds, { budget, record: runs.length === 0 }));
  }
  const completing = runs.findIndex(({ outcome }) => outcome === 'completed');
  if (completing < 0) yield null;
  const impossible = completing < 0 ? proveGoalImpossible(scene, { minerals: 'any' }, proofs) : null;
  const ends = scriptEnds(level.runs, runs);
  const verdict = verdictOfFindings({ ends, impossible, searched: null });
  const shown = runs.length === 0 ? null : Math.max(0, completing);
  const run = shown === null || runs[shown].stopped !== null ? null : runs[shown];
  return { scene, runs, ends, impossible, verdict, shown, run, budget, proofs };
}

/** {@link briefInSteps} at once. */
export const brief = (level: Level, terms: Terms): Brief => atOnce(briefInSteps(level, terms));

/** Does all steps at once. */
export function atOnce<R>(steps: Generator<null, R, void>): R {
  for (;;) {
    const step = steps.next();
    if (step.done === true) return step.value;
  }
}

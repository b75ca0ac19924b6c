/**
 * Checks levels: it simulates their runs, collects what is wrong or looks wrong, and decides the verdict. The command line and
 * the editor share this code and differ only in the hints that they give.
 *
 * @module
 */
export { atOnce, type Brief, brief, briefInSteps } from './brief.ts';
export { completingRuns, ticksToAgree, tightRuns } from './certified-ticks.ts';
export { type CheapestSetting, findCheapestSetting, type KeptRun } from './cheapest-setting.ts';
export { examineInSteps, examineRuns, playRuns } from './examine-runs.ts';
export {
  type Findings,
  findingsOf,
  type LevelVerdict,
  onceProved,
  type RunFindings,
  type Searched,
  type Softlocks,
  softlocksOf,
  unproved,
  verdictOfFindings,
} from './findings.ts';
export { createMend, type Mend, type Mended, type MendOptions, mendedInWords, repairedFile } from './mend/index.ts';
export { applyPolicy } from './policy/index.ts';
export { type Hints, type LevelProblem, problemsOf, proofProblems } from './problems/index.ts';
export { type LostMineral, mineralsToProve, proofBudget, proveGoalImpossible, proveMineralsLost } from './proofs.ts';
export { withinWork } from './within-work.ts';

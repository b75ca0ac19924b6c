/**
 * Checks levels: it simulates their runs, collects what is wrong or looks wrong, and decides the verdict. The command line and
 * the editor share this code and differ only in the hints that they give.
 *
 * @module
 */
export { type Brief, brief, briefInSteps } from './brief.ts';
export { ticksToAgree } from './certified-ticks.ts';
export { examineRuns, playRuns } from './examine-runs.ts';
export {
  type Findings,
  findingsOf,
  type RunFindings,
  type Searched,
  unproved,
  verdictOfFindings,
} from './findings.ts';
export { createMend, type Mend, type Mended, type MendOptions, mendedInWords } from './mend/index.ts';
export { applyPolicy } from './policy/index.ts';
export { type Hints, type LevelProblem, problemsOf, proofProblems } from './problems/index.ts';
export { type LostMineral, mineralsToProve, proofBudget, proveGoalImpossible, proveMineralsLost } from './proofs.ts';
export { repairedFile } from './repaired-file.ts';
export { type Softlocks, softlocksOf } from './softlocks.ts';
export { completingRuns, tightRuns } from './tight-runs.ts';
export { type LevelVerdict, onceProved } from './verdict.ts';
export { withinWork } from './within-work.ts';

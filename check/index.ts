export { type ExamineOptions, examineRuns, playRuns } from './examine-runs.ts';
export {
  type Findings,
  findingsOf,
  type RunFindings,
  type Searched,
  unproved,
  verdictOfFindings,
} from './findings.ts';
export { type Hints, type LevelProblem, problemsOf, proofProblems } from './problems/index.ts';
export { type LostMineral, mineralsToProve, proveGoalImpossible, proveMineralsLost } from './proofs.ts';
export { completingRuns, tightRuns } from './tight-runs.ts';
export { type LevelVerdict, onceProved, verdictOf } from './verdict.ts';
export { withinWork } from './within-work.ts';

/**
 * The solver finds runs, measures how robust they are, grades and generates levels, and proves that a level cannot be
 * completed.
 *
 * It uses neither clock nor threads. Work that takes long is an object with an `advance(ticks)` method, or a generator whose
 * name ends in `InSteps`; its cost is counted in simulated ticks (1/60 s), and the same total gives the same result however it
 * is split.
 *
 * Every run that is reported has been replayed from the start by {@link verifyRun}, at the accuracy of the scene. Every proof
 * that `gq` reports has been confirmed by {@link verifyProof}.
 *
 * @module
 */

export {
  createGenerator,
  createPackJudge,
  type Generated,
  type GeneratorOptions,
  INGREDIENTS,
  type Ingredient,
  type LevelGenerator,
  nearestDistances,
  type PackJudge,
  type PackOptions,
  type PackTheme,
  packLevel,
  type Rejection,
  SYMMETRIES,
  type SymmetryKind,
  type SymmetryMeasure,
  THEME_NAMES,
  type ThemeMeasure,
  type ThemeName,
  USUAL_INGREDIENTS,
  type Variety,
  varietyOf,
  type WantedDifficulty,
  type WantedSize,
} from './make/generate/index.ts';
export {
  applyChange,
  type Change,
  changeEdits,
  changeSize,
  createRepair,
  type LevelEdit,
  type ObjectRef,
  type Proposal,
  type Repair,
  type RepairOptions,
  type RunOrigin,
  type Vector,
} from './make/repair/index.ts';
export { createRetime, type Retime, type Retimed, type RetimeOptions } from './make/retime/index.ts';
export {
  type AsteroidUse,
  type ComparedRun,
  type Difficulty,
  type DifficultyOptions,
  type FoundRuns,
  findRuns,
  findShortcuts,
  GRADE_WORDS,
  type Grade,
  type GradeWord,
  type MineralsExtra,
  measureDifficulty,
  type OnePress,
  PLAYER_EFFORT,
  type RandomPlay,
  type RunComparison,
  type ShortcutOptions,
  type Shortcuts,
  type SigmaAtHalf,
  type WithoutAsteroid,
} from './measure/difficulty/index.ts';
export {
  createPlayers,
  type FitInterval,
  type ForecastAttempt,
  fitPlayers,
  type ObservedAttempt,
  type PlayedAttempt,
  type PlayerFit,
  type PlayerForecast,
  type PlayerOptions,
  type PlayerParameters,
  type PlayerPopulation,
  type PlayerShare,
  playAsPlayers,
  UNCALIBRATED,
} from './measure/player/index.ts';
export {
  BRIEF_CERTIFY_RUNS,
  type Certification,
  type CertifyOptions,
  certify,
  type EdgeSlack,
  findSlack,
  findSlackInSteps,
  measureRobustness,
  measureRobustnessInSteps,
  type Robustness,
  type RobustnessOptions,
  type SampleOptions,
  type Success,
  successInSteps,
  successProbability,
} from './measure/robustness/index.ts';
export {
  createSoftlockSurvey,
  LIVES_ON,
  type LostPlace,
  type RunLoss,
  type SoftlockSurvey,
  type Standing,
  type SurveyedState,
  type SurveyOptions,
} from './measure/softlock/index.ts';
export {
  type About,
  type BarrierEdge,
  type Blocker,
  type BoxNumbers,
  type Certificate,
  type DeadEnd,
  type Direction,
  type Doomed,
  type Drift,
  type FanGrid,
  FINEST,
  type Flowpipe,
  type LineEnd,
  type LineTrap,
  type OrbitGrid,
  type Orbits,
  OUTDONE_WARNINGS,
  type PipeGrid,
  type PipePart,
  type PipeStep,
  PROVERS,
  type Proof,
  type ProofCode,
  type ProofPicture,
  type ProofRole,
  type ProveOptions,
  proofPicture,
  proveBy,
  proveImpossible,
  proveMineralsUnreachable,
  type Strip,
  type ThingRef,
} from './prove/index.ts';
export { createRandom, type Random } from './random.ts';
export {
  type AnytimeOptions,
  type AnytimeProof,
  createAnytimeProof,
  createDecider,
  type Decider,
  type DeciderOptions,
  proofShare,
} from './search/anytime/index.ts';
export {
  type Closest,
  createSearch,
  type Effort,
  type Explored,
  type Moment,
  type Search,
  type SearchOptions,
} from './search/explore/index.ts';
export {
  type Cleaned,
  type CleanOptions,
  cleanRun,
  createSolver,
  mergeSolutions,
  type Objective,
  type Solution,
  type SolveOptions,
  type Solver,
} from './search/solve/index.ts';
export type { Steps } from './steps.ts';
export { type Candidate, createReplay, cutHolds, type Goal, mineralsNeeded, type Replay, verifyRun } from './verified-run.ts';
export { type Verification, verifyProof } from './verify/index.ts';

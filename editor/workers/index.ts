export { type AnswerOf, type AskedOf, accuracyNameOf, follow, type Job, type ProgressOf } from './job.ts';
export * as jobs from './jobs/index.ts';
export {
  FAN_TICKS,
  type Fan,
  type FanWay,
  type Fixing,
  type Leeway,
  type LevelFacts,
  type Losing,
  type Loss,
  type Losses,
  type LostKnown,
  type LostMoment,
  type LostState,
  type Mending,
  type Proofs,
  type Retiming,
  type Setting,
  type SettingError,
  type Solving,
  type Thumbnail,
  type TimedEffects,
} from './jobs/index.ts';
export {
  CELL_NUMBERS,
  type CellState,
  cornerCompletes,
  MOST_REACH,
  type Reach,
  stateOfCode,
} from './leeway/index.ts';
export type { JobKind, Requests, Results } from './runner.ts';
export { createWorkers, type JobEnd, type Running, spawnPageWorker, type WorkerPort, type Workers } from './workers.ts';

export {
  CELL_NUMBERS,
  type CellState,
  cornerCompletes,
  MOST_REACH,
  type Reach,
  stateOfCode,
} from './leeway/index.ts';
export { oneAtATime } from './one-at-a-time.ts';
export { spawnPageWorker } from './page-worker.ts';
export {
  FAN_TICKS,
  type Fan,
  type FanWay,
  type Fixing,
  type JobKind,
  type Leeway,
  type LevelFacts,
  type Losing,
  type Loss,
  type Losses,
  type LostKnown,
  type LostMoment,
  type LostState,
  type Mending,
  type Requests,
  type Results,
  type Retiming,
  type Setting,
  type Solving,
} from './protocol.ts';
export { createWorkers, type Job, type JobEnd, type WorkerPort, type Workers } from './workers.ts';

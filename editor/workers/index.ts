export { spawnPageWorker } from './page-worker.ts';
export {
  FAN_TICKS,
  type Fan,
  type FanWay,
  type Fixing,
  type JobKind,
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

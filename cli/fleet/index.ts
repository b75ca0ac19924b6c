export { addToLeast, MOST_ASSIGNED } from './balance.ts';
export { reportWhole } from './do-whole.ts';
export { type Gathered, gather, resultsIn } from './gather.ts';
export { contentsOf, JOBS, type JobName } from './job.ts';
export { jobOf } from './jobs/index.ts';
export { makePlan } from './make-plan.ts';
export { MOST_SHARDS, type Plan, planText, readPlan } from './plan.ts';
export { readCosts } from './read-costs.ts';
export { mergedRecords, replaySample } from './replay.ts';
export { recordOfLine } from './result.ts';
export { ignoreFor, setPaths } from './set-paths.ts';
export { chooseShard, type Environment, shardOfPlan } from './shard-command.ts';
export {
  arrayJob,
  logsOf,
  maxArraySize,
  mergeJob,
  rangesOf,
  readRanges,
  reportOf,
  type SlurmOrder,
  submission,
  submitJob,
  USUAL_ARRAY_SIZE,
} from './slurm.ts';

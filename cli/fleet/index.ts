export { rangesOf, readRanges } from './ranges.ts';
export { maxArraySize, submitJob, USUAL_ARRAY_SIZE } from './sbatch.ts';
export { chooseShard, type Environment, type ShardChoice } from './shard-number.ts';
export { arrayJob, logsOf, mergeJob, reportOf, type SlurmOrder, submission } from './slurm.ts';

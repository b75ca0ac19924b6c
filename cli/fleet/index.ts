export { rangesOf, readRanges } from './ranges.ts';
export { chooseShard, type Environment, type ShardChoice } from './shard-number.ts';

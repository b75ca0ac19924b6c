export { CHROMIUM, launch, NO_TOUR, QUIET } from './chromium.ts';
export { type Comparison, type Contestant, compare, timeCells } from './compare.ts';
export { ADDRESS, type Ended, GQ, inFolder, PROJECT, runGq, started, tryGq } from './gq.ts';
export {
  askedLevels,
  copiedLevels,
  LEVELS,
  type NamedFile,
  type NamedLevel,
  originalFiles,
  packFiles,
  packLevels,
  writeLevels,
  writeLines,
} from './levels.ts';
export { movedLevel } from './moved-level.ts';
export {
  ACCURACY_NAMES,
  type Asked,
  accuracy,
  atLeast,
  atMost,
  type Bench,
  define,
  flag,
  number,
  numbers,
  oneOf,
  optionName,
  readOptions,
  text,
  words,
} from './record.ts';
export { consume, figure, keeps, machine, publish, tableOf, verdictsOf } from './report.ts';
export { lowerRank, mean, median, nearestRank, processorClock, processorTime, spread, sum } from './statistics.ts';

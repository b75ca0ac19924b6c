export {
  addShardOptions,
  collect,
  formatOption,
  jobsOption,
  LARGEST_SEED,
  numberOption,
  refuseBesidesPlan,
  refuseUnused,
  type ShardOptions,
  seedOption,
  wholeNumberOption,
} from './common.ts';
export {
  addSearchOptions,
  expectMinerals,
  type Limits,
  limitsOf,
  mineralsOption,
  objectiveOption,
  type SearchOptions,
  USUAL_EFFORT,
} from './search.ts';
export {
  accuracyOption,
  addTermsOptions,
  customAccuracy,
  maxTimeOption,
  maxWorkOption,
  type TermsOptions,
  termsFrom,
} from './terms.ts';

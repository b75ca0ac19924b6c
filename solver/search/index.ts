export type { Candidate } from '../verified-run.ts';
export { createSearch } from './cell-search.ts';
export { HeatMap, HeatTally } from './heat-map.ts';
export type { Closest, Effort, Explored, Moment, Search, SearchOptions } from './search.ts';

export { HeatMap, HeatTally } from './heat-map.ts';
export { createSearch } from './lane-search.ts';
export type { Closest, Effort, Explored, Moment, Search, SearchOptions } from './search.ts';
